#include "hlsl/rewrites/Spelling.h"

#include "hlsl/Editor.h"
#include "hlsl/rewrites/Initializers.h"
#include "hlsl/rewrites/Loops.h"
#include "hlsl/rewrites/OldForms.h"
#include "hlsl/rewrites/Structs.h"
#include "hlsl/rewrites/UniformParameters.h"
#include "text/Text.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace limn
{

namespace
{

// Words that mean something before a type, so that another word follows.
constexpr std::array<std::string_view, 7> k_StageModifiers = {
    "linear", "centroid", "point", "line", "triangle", "triangleadj", "lineadj"};

// Types, and a word of GLSL, that name members and variables as well.
constexpr std::array<std::string_view, 6> k_TypeNames = {"sampler", "texture", "matrix",
                                                         "vector",  "string",  "layout"};

template <std::size_t N>
bool Contains(const std::array<std::string_view, N>& words, std::string_view word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// "_m03_m13" is {"_m03", "_m13"}, "_11" is {"_11"}; empty for everything else.
std::vector<std::string_view> MatrixElements(std::string_view word)
{
    const std::size_t size = word.substr(0, 2) == "_m" ? 4 : 3;
    std::vector<std::string_view> elements;
    for (; !word.empty(); word.remove_prefix(size))
    {
        const bool isElement = word.size() >= size && word[0] == '_' && isDigit(word[size - 1]) &&
                               isDigit(word[size - 2]) && (size == 3 || word[1] == 'm');
        if (!isElement)
        {
            return {};
        }
        elements.push_back(word.substr(0, size));
    }
    return elements;
}

/// The elements that "xzz" takes of a vector; none where it takes what is not there.
std::vector<std::string_view> Swizzle(const std::vector<std::string_view>& elements,
                                      std::string_view letters)
{
    std::vector<std::string_view> result;
    for (const char letter : letters)
    {
        const std::size_t xyzw = std::string_view("xyzw").find(letter);
        const std::size_t index = std::min(xyzw, std::string_view("rgba").find(letter));
        if (index >= elements.size())
        {
            return {};
        }
        result.push_back(elements[index]);
    }
    return result;
}

class Speller
{
public:
    explicit Speller(const std::string& text) : m_Code(text) {}

    std::string Spell()
    {
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            if (isWord(i))
            {
                SpellWord(i);
            }
        }
        return m_Code.Assemble();
    }

private:
    std::string_view Text(std::size_t index) const { return m_Code.Text(index); }
    bool isWord(std::size_t index) const { return m_Code.isWord(index); }

    void SpellWord(std::size_t index)
    {
        const std::string_view word = Text(index);
        if (word == "shared" || (Contains(k_StageModifiers, word) && !isWord(index + 1)))
        {
            m_Code.Spelling(index) = std::string(word) + "_";
        }
        else if (word == "noise" && Text(index + 1) == "(")
        {
            // The language has a function of this name that no device knows; glslang crashes on it.
            m_Code.Spelling(index) = "noise_";
        }
        else if (word == "sampler" && isSampledBy(Text(index + 1)))
        {
            m_Code.Spelling(index) = "SamplerState";
        }
        else if (word == "Buffer" && (isWord(index + 1) || Text(index + 1) == "<"))
        {
            // A device reads both kinds alike; limn binds the structured one.
            m_Code.Spelling(index) =
                isWord(index + 1) ? "StructuredBuffer<float4>" : "StructuredBuffer";
        }
        else if ((Contains(k_TypeNames, word) && isNameHere(index)) || isTypeAsSemantic(index))
        {
            m_Code.Spelling(index) = std::string(word) + "_";
        }
        else if (word[0] == '_' && index > 1 && Text(index - 1) == ".")
        {
            SpellMatrixSwizzle(index);
        }
    }

    /// Whether the word is a variable or a member, not a type: `v.matrix`, but not `matrix m` or
    /// `(matrix)v`.
    bool isNameHere(std::size_t index) const
    {
        const std::string_view next = Text(index + 1);
        const bool isCast = Text(index - 1) == "(" && next == ")" && !isWord(index - 2);
        return !isWord(index + 1) && next != "<" && next != "(" && !isCast;
    }

    /// `float4 c : float4;`
    bool isTypeAsSemantic(std::size_t index) const
    {
        const std::string_view word = Text(index);
        const std::string_view next = Text(index + 1);
        const bool isType = Contains(k_TypeNames, word) || word.substr(0, 5) == "float" ||
                            word.substr(0, 3) == "int" || word.substr(0, 4) == "uint";
        return isType && Text(index - 1) == ":" && isWord(index - 2) &&
               (next == ";" || next == "," || next == ")" || next == "{");
    }

    /// Whether a method of a texture takes it: `_Tex.Sample(name, …)`.
    bool isSampledBy(std::string_view name) const
    {
        for (std::size_t i = 3; i < m_Code.size() && !name.empty(); ++i)
        {
            if (Text(i) == name && Text(i - 1) == "(" && Text(i - 3) == "." &&
                (Text(i - 2).substr(0, 6) == "Sample" || Text(i - 2).substr(0, 6) == "Gather" ||
                 Text(i - 2) == "CalculateLevelOfDetail"))
            {
                return true;
            }
        }
        return false;
    }

    /// `M._m03_m13.yx` becomes `float2(M._m13, M._m03)`: what glslang 12 makes of the swizzle
    /// itself is not valid, but for the left side of `=`.
    void SpellMatrixSwizzle(std::size_t index)
    {
        std::vector<std::string_view> elements = MatrixElements(Text(index));
        const std::string_view next = Text(index + 1);
        const bool isAssigned = next.size() < 3 && next != "==" && !next.empty() &&
                                next.back() == '=' && next != "!=" && next != "<=" && next != ">=";
        if (elements.size() < 2 || isAssigned)
        {
            return;
        }
        std::size_t last = index;
        if (Text(index + 1) == ".")
        {
            elements = Swizzle(elements, Text(index + 2));
            last = index + 2;
        }
        const std::size_t first = FirstOfOperand(index - 2);
        std::string operand;
        for (std::size_t i = first; i < index - 1; ++i)
        {
            operand += m_Code.Spelling(i);
        }
        std::string text;
        for (const std::string_view element : elements)
        {
            text += (text.empty() ? "" : ", ") + operand + "." + std::string(element);
        }
        if (elements.empty())
        {
            return;
        }
        m_Code.Erase(first, last + 1);
        // The preprocessor leaves no blank between `return` and a bracket.
        m_Code.Spelling(first) = " ";
        m_Code.Spelling(first) +=
            elements.size() == 1 ? text
                                 : "float" + std::to_string(elements.size()) + "(" + text + ")";
    }

    /// Where the operand of `.` begins that ends at a token: `a.b[i]`, `f(x)`, `(x)`.
    std::size_t FirstOfOperand(std::size_t index) const
    {
        for (;;)
        {
            if (Text(index) == "]")
            {
                index = MatchingOpen(index);
                index -= index > 0 ? 1 : 0;
                continue;
            }
            if (Text(index) == ")")
            {
                index = MatchingOpen(index);
                const bool isCall = index > 0 && isWord(index - 1) && Text(index - 1) != "return";
                index -= isCall ? 1 : 0;
            }
            if (index < 2 || Text(index - 1) != ".")
            {
                return index;
            }
            index -= 2;
        }
    }

    std::size_t MatchingOpen(std::size_t index) const
    {
        int depth = 0;
        for (;; --index)
        {
            depth += Text(index) == ")" || Text(index) == "]" ? 1 : 0;
            depth -= Text(index) == "(" || Text(index) == "[" ? 1 : 0;
            if (depth <= 0 || index == 0)
            {
                return index;
            }
        }
    }

    HlslEditor m_Code;
};

} // namespace

std::string RespellForGlslang(std::string text, const PassProgram& program,
                              std::vector<Diagnostic>& warnings)
{
    text = TakeOldForms(std::move(text), warnings);
    text = CopyBaseMembers(std::move(text));
    text = GroupInitializers(std::move(text));
    text = TakeUniformParameters(
        std::move(text), {program.vertex.name, program.geometry.name, program.fragment.name});
    text = HoistLoopVariables(std::move(text));
    return Speller(text).Spell();
}

} // namespace limn
