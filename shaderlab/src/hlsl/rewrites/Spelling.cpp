#include "hlsl/rewrites/Rewrites.h"

#include "hlsl/Checks.h"
#include "hlsl/Editor.h"
#include "hlsl/Types.h"
#include "text/WordList.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace limn
{

namespace
{

// Words that mean something before a type, so that another word follows.
const WordList k_StageModifiers("linear centroid point line triangle triangleadj lineadj");

// Types, and a word of GLSL, that name members and variables as well.
const WordList k_TypeNames("sampler texture matrix vector string layout");

const WordList k_ObjectModifiers("static uniform extern in");

class Speller
{
public:
    explicit Speller(HlslEditor& code) : m_Code(code) {}

    void Spell()
    {
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            if (isWord(i))
            {
                SpellWord(i);
            }
            else if (Text(i).starts_with("0x") || Text(i).starts_with("0X"))
            {
                CutNumber(i);
            }
        }
    }

private:
    std::string_view Text(std::size_t index) const { return m_Code.Text(index); }
    bool isWord(std::size_t index) const { return m_Code.isWord(index); }

    void SpellWord(std::size_t index)
    {
        const std::string_view word = Text(index);
        if (word == "shared" || (!isWord(index + 1) && k_StageModifiers.Has(word)))
        {
            m_Code.Spelling(index) = std::string(word) + "_";
        }
        else if (word == "struct" && isWord(index + 1) && Text(index + 2) != "{" &&
                 Text(index + 2) != ":" && Text(index + 2) != ";")
        {
            m_Code.Spelling(index).clear(); // before the name of a type, as in C
        }
        else if ((word == "noise" || word == "msad4") && Text(index + 1) == "(")
        {
            // The language has them and no device does; glslang crashes on them.
            m_Code.Spelling(index) = std::string(word) + "_";
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
        else if ((k_TypeNames.Has(word) && isNameHere(index)) || isTypeAsSemantic(index))
        {
            m_Code.Spelling(index) = std::string(word) + "_";
        }
        else if (Text(index + 1) == "::" && Text(index + 3) == "(" && isFirst(index))
        {
            // What begins with a type is a declaration to glslang: `Type::Method();`
            m_Code.Spelling(index).insert(0, "(");
            m_Code.Spelling(m_Code.AfterBracket(index + 3) - 1) += ")";
        }
        else if (word == "const" && isObject(index + 1))
        {
            m_Code.Spelling(index).clear(); // it says nothing; glslang crashes on it
        }
        else if ((word == "vector" || word == "matrix") && Text(index + 1) == "<")
        {
            SplitTemplateEnd(index + 2);
        }
    }

    /// To its lowest 32 bits, eight digits.
    void CutNumber(std::size_t index)
    {
        const std::string_view text = Text(index).substr(2);
        const std::size_t size =
            std::min(text.find_first_not_of("0123456789abcdefABCDEF"), text.size());
        if (size > 8)
        {
            m_Code.Spelling(index) = "0x" + std::string(text.substr(size - 8));
        }
    }

    /// Whether a statement begins with the word.
    bool isFirst(std::size_t index) const
    {
        const std::string_view before = Text(index - 1);
        return before == ";" || before == "{" || before == "}" || before == ")" || before == "else";
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
        const bool isType = k_TypeNames.Has(word) || word.starts_with("float") ||
                            word.starts_with("int") || word.starts_with("uint");
        return isType && Text(index - 1) == ":" && isWord(index - 2) &&
               (next == ";" || next == "," || next == ")" || next == "{");
    }

    /// Whether a texture, sampler or buffer is declared here, modifiers first.
    bool isObject(std::size_t index) const
    {
        while (k_ObjectModifiers.Has(Text(index)))
        {
            ++index;
        }
        return isObjectType(Text(index)) && (isWord(index + 1) || Text(index + 1) == "<");
    }

    /// `Texture2D<vector<float, 4>>`: here `>>` is no shift.
    void SplitTemplateEnd(std::size_t index)
    {
        while (isWord(index) || Text(index) == "," ||
               (!Text(index).empty() && isDigit(Text(index)[0])))
        {
            ++index;
        }
        if (Text(index) == ">>")
        {
            m_Code.Spelling(index) = "> >";
        }
    }

    /// Whether a method of a texture takes it: `_Tex.Sample(name, …)`.
    bool isSampledBy(std::string_view name) const
    {
        for (std::size_t i = 3; i < m_Code.size() && !name.empty(); ++i)
        {
            if (Text(i) == name && Text(i - 1) == "(" && Text(i - 3) == "." &&
                (Text(i - 2).starts_with("Sample") || Text(i - 2).starts_with("Gather") ||
                 Text(i - 2) == "CalculateLevelOfDetail"))
            {
                return true;
            }
        }
        return false;
    }

    HlslEditor& m_Code;
};

} // namespace

std::string RespellForGlslang(std::string text, const PassProgram& program, SourceLines& lines,
                              std::vector<Diagnostic>& warnings)
{
    std::optional<HlslTokens> tokens(std::in_place, text, &lines);
    std::optional<HlslEditor> code(std::in_place, *tokens);
    RequireShallow(*tokens);
    RequirePairs(*tokens);
    const auto rewrite = [&](const auto& edit)
    {
        edit(*code);
        if (code->isEdited()) // as hardly ever
        {
            text = code->Assemble();
            tokens.emplace(text, &lines);
            code.emplace(*tokens);
        }
    };
    rewrite(SpellEnums);
    rewrite(TakeStructsOutOfBuffers);
    rewrite(TakeNamespaces);
    rewrite(CopyBaseMembers);
    rewrite(TakeStaticMembers);
    rewrite(
        [&](HlslEditor& whole)
        {
            TakeUniformParameters(
                whole, {program.vertex.name, program.geometry.name, program.fragment.name});
        });
    TakeOldForms(*code, warnings);
    Speller(*code).Spell();
    return code->Assemble();
}

} // namespace limn
