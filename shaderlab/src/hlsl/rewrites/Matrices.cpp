#include "hlsl/rewrites/Rewrites.h"

#include "hlsl/Editor.h"
#include "text/Text.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace limn
{

namespace
{

constexpr std::array<std::string_view, 4> k_ScalarTypes = {"float", "int", "uint", "bool"};

/// `int3x4`; no rows where a word is no such type.
struct MatrixType
{
    std::string_view scalar;
    int rows = 0;
    int columns = 0;

    std::string Name() const
    {
        return std::string(scalar) + std::to_string(rows) + "x" + std::to_string(columns);
    }
};

MatrixType ReadMatrixType(std::string_view word)
{
    const auto isSize = [](char c)
    {
        return c >= '2' && c <= '4';
    };
    word = word == "matrix" ? "float4x4" : word;
    for (const std::string_view scalar : {"float", "int", "uint"})
    {
        const std::string_view size = word.starts_with(scalar) ? word.substr(scalar.size()) : "";
        if (size.size() == 3 && isSize(size[0]) && size[1] == 'x' && isSize(size[2]))
        {
            return {scalar, size[0] - '0', size[2] - '0'};
        }
    }
    return {};
}

/// Calls a function for each float matrix of at least this size.
template <typename F>
void ForEachMatrix(int rows, int columns, F&& each)
{
    for (int row = rows; row <= 4; ++row)
    {
        for (int column = columns; column <= 4; ++column)
        {
            each(MatrixType{"float", row, column}.Name());
        }
    }
}

/// One overload for each type that the language casts to the matrix.
std::string WriteCast(const MatrixType& type, const std::string& function)
{
    const std::string name = type.Name();
    std::string elements;
    for (int i = 0; i < type.rows * type.columns; ++i)
    {
        elements.append(i > 0 ? ", " : "").append(type.scalar).append("(v)");
    }
    std::string text;
    const auto add = [&](std::string_view parameter, const std::string& value)
    {
        text.append(name).append(" ").append(function).append("(").append(parameter);
        text.append(" v) { return ").append(value).append("; } ");
    };
    for (const std::string_view scalar : k_ScalarTypes)
    {
        add(scalar, name + "(" + elements + ")");
    }
    if (type.rows * type.columns == 4)
    {
        add("float4", name + "(v.x, v.y, v.z, v.w)");
    }
    ForEachMatrix(type.rows, type.columns,
                  [&](const std::string& larger) { add(larger, "(" + name + ")v"); });
    return text;
}

/// The functions of both kinds come before the first token.
std::string Assemble(HlslEditor& code, const std::string& functions)
{
    if (code.size() > 0)
    {
        code.Spelling(0).insert(0, functions);
    }
    return code.Assemble();
}

/// Tells initialisers of what is static from other code: glslang crashes on calls in them.
class InitializerScope
{
public:
    explicit InitializerScope(const HlslEditor& code) : m_Code(code) {}

    /// For each token in turn.
    bool isInitial(std::size_t index)
    {
        const std::string_view text = m_Code.Text(index);
        if (text == "{")
        {
            const bool isFunction =
                index > 1 && (m_Code.Text(index - 1) == ")" || m_Code.Text(index - 2) == ":");
            m_BodyDepth += m_BodyDepth > 0 || isFunction ? 1 : 0;
            m_IsStatic = m_IsStatic && !isFunction;
        }
        m_BodyDepth -= text == "}" && m_BodyDepth > 0 ? 1 : 0;
        m_IsStatic = text == "static" || (m_IsStatic && text != ";");
        return m_BodyDepth == 0 || m_IsStatic;
    }

private:
    const HlslEditor& m_Code;
    int m_BodyDepth = 0;     ///< braces open in a function
    bool m_IsStatic = false; ///< in a declaration of something static
};

/// `matrix<float, 3, 3>` is `float3x3`.
std::string SpellTemplates(std::string text)
{
    HlslEditor code(text);
    const auto isSize = [&](std::size_t index)
    {
        return code.Text(index).size() == 1 && isDigit(code.Text(index)[0]);
    };
    for (std::size_t i = 0; i < code.size(); ++i)
    {
        if (code.Text(i) == "matrix" && code.Text(i + 1) == "<" && code.isWord(i + 2) &&
            isSize(i + 4) && isSize(i + 6) && code.Text(i + 7).starts_with(">"))
        {
            code.Spelling(i) = std::string(code.Text(i + 2)).append(code.Text(i + 4)) + "x" +
                               std::string(code.Text(i + 6)) + " ";
            code.Erase(i + 1, i + 7);
            code.Spelling(i + 7).erase(0, 1); // `>>` ends two templates
        }
    }
    return code.Assemble();
}

class CastSpeller
{
public:
    explicit CastSpeller(const std::string& text) : m_Code(text), m_Scope(m_Code) {}

    std::string Spell()
    {
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            m_IsInitial = m_Scope.isInitial(i);
            const MatrixType type = m_Code.isWord(i) ? TypeOf(Text(i)) : MatrixType();
            if (type.rows > 0 && i > 0 && Text(i - 1) == "typedef" && Text(i + 2) == ";")
            {
                m_Aliases[Text(i + 1)] = type;
                continue;
            }
            const bool isCastHere = type.rows > 0 && isCast(i);
            if (isCastHere || (type.rows > 0 && isConstructorOfOne(i)))
            {
                const std::size_t end =
                    isCastHere ? EndOfOperand(i + 2) : m_Code.AfterBracket(i + 1);
                m_IsInitial ? SpellInitial(type, i + 1, end) : SpellCall(type, i, isCastHere, end);
            }
        }
        return Assemble(m_Code, m_Functions);
    }

private:
    std::string_view Text(std::size_t index) const { return m_Code.Text(index); }

    MatrixType TypeOf(std::string_view word) const
    {
        const auto alias = m_Aliases.find(word);
        return alias == m_Aliases.end() ? ReadMatrixType(word) : alias->second;
    }

    /// `(float3x3)n` becomes `limn_float3x3(n)`.
    void SpellCall(const MatrixType& type, std::size_t index, bool isCastHere, std::size_t end)
    {
        if (!isCastHere)
        {
            m_Code.Spelling(index) = Function(type);
            return;
        }
        m_Code.Erase(index - 1, index + 2);
        m_Code.Spelling(index - 1) = " " + Function(type) + "(";
        m_Code.Spelling(end - 1) += ")";
    }

    /// `(float3x3)n` becomes `(float3x3)(1.0 * (n))`.
    void SpellInitial(const MatrixType& type, std::size_t bracket, std::size_t end)
    {
        if (type.scalar == "float")
        {
            m_Code.Spelling(bracket) += Text(bracket) == ")" ? "(1.0 * (" : "1.0 * (";
            m_Code.Spelling(end - 1) += Text(bracket) == ")" ? "))" : ")";
        }
    }

    std::string Function(const MatrixType& type)
    {
        const std::string function = "limn_" + type.Name();
        if (m_Known.insert(function).second)
        {
            m_Functions += WriteCast(type, function);
        }
        return function;
    }

    static bool isSign(std::string_view text)
    {
        return text == "+" || text == "-" || text == "!" || text == "~";
    }

    /// Whether a value can begin at the token, signs aside.
    bool isValue(std::size_t index) const
    {
        const std::string_view text = Text(index);
        return m_Code.isWord(index) || text == "(" || (!text.empty() && isDigit(text[0])) ||
               (text.size() > 1 && text[0] == '.');
    }
    bool isOperand(std::size_t index) const { return isValue(index) || isSign(Text(index)); }

    /// `(type)value` around the type, not the parameters of `float3 f(float3x3);`.
    bool isCast(std::size_t index) const
    {
        const bool isInBrackets = index > 0 && Text(index - 1) == "(" && Text(index + 1) == ")";
        const bool isCall = index > 1 && m_Code.isWord(index - 2) && Text(index - 2) != "return";
        // A variable may be called matrix, and stand in brackets before a sign.
        const bool isVariable = Text(index) == "matrix" && isSign(Text(index + 2));
        return isInBrackets && !isCall && !isVariable && isOperand(index + 2);
    }

    /// `type(value)`: with several values it is a constructor as glslang knows it.
    bool isConstructorOfOne(std::size_t index) const
    {
        return Text(index + 1) == "(" && Text(index + 2) != ")" &&
               Text(m_Code.FindOutside(index + 2, ",")) == ")";
    }

    /// The token behind the value that a cast before it takes: signs, further casts, a name, number
    /// or brackets, and what is called, indexed or picked of it.
    std::size_t EndOfOperand(std::size_t index) const
    {
        const auto isFurtherCast = [&]
        {
            return Text(index) == "(" && m_Code.isWord(index + 1) && Text(index + 2) == ")" &&
                   isValue(index + 3);
        };
        while (isSign(Text(index)) || isFurtherCast())
        {
            index += isSign(Text(index)) ? 1 : 3;
        }
        index = Text(index) == "(" ? m_Code.AfterBracket(index) : index + 1;
        while (Text(index) == "." || Text(index) == "[" || Text(index) == "(")
        {
            index = Text(index) == "." ? index + 2 : m_Code.AfterBracket(index);
        }
        return std::min(index, m_Code.size());
    }

    HlslEditor m_Code;
    InitializerScope m_Scope;
    bool m_IsInitial = false;
    std::map<std::string_view, MatrixType> m_Aliases; ///< by typedef
    std::set<std::string> m_Known;
    std::string m_Functions;
};

/// "_m03_m13" is {"_m03", "_m13"}, "_11" is {"_11"}; empty for everything else.
std::vector<std::string_view> MatrixElements(std::string_view word)
{
    const std::size_t size = word.starts_with("_m") ? 4 : 3;
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
std::vector<std::string_view> PickElements(const std::vector<std::string_view>& elements,
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

/// One overload for each matrix that has the elements.
std::string WriteSwizzle(const std::vector<std::string_view>& elements, const std::string& function)
{
    int rows = 2;
    int columns = 2;
    std::string values;
    for (const std::string_view element : elements)
    {
        const int first = element[1] == 'm' ? 0 : 1;
        rows = std::max(rows, element[element.size() - 2] - '0' + 1 - first);
        columns = std::max(columns, element[element.size() - 1] - '0' + 1 - first);
        values.append(values.empty() ? "v." : ", v.").append(element);
    }
    const std::string type =
        elements.size() > 1 ? "float" + std::to_string(elements.size()) : "float";
    std::string text;
    ForEachMatrix(rows, columns,
                  [&](const std::string& matrix)
                  {
                      text += type + " " + function + "(" + matrix + " v) { return " + type + "(" +
                              values + "); } ";
                  });
    return text;
}

class SwizzleSpeller
{
public:
    explicit SwizzleSpeller(const std::string& text) : m_Code(text) {}

    std::string Spell()
    {
        InitializerScope scope(m_Code);
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            const bool isInitial = scope.isInitial(i);
            if (Text(i)[0] == '_' && i > 1 && Text(i - 1) == ".")
            {
                SpellSwizzle(i, isInitial);
            }
        }
        return Assemble(m_Code, m_Functions);
    }

private:
    std::string_view Text(std::size_t index) const { return m_Code.Text(index); }

    /// `M._m03_m13.yx` becomes `limn_m13_m03(M)`, but for the left side of `=`.
    void SpellSwizzle(std::size_t index, bool isInitial)
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
        if (next == ".")
        {
            elements = PickElements(elements, Text(index + 2));
            last = index + 2;
        }
        if (elements.empty())
        {
            return;
        }
        const std::size_t first = FirstOfOperand(index - 2);
        if (isInitial)
        {
            SpellEach(elements, first, index - 1, last);
            return;
        }
        std::string function = "limn";
        for (const std::string_view element : elements)
        {
            function += element;
        }
        if (m_Known.insert(function).second)
        {
            m_Functions += WriteSwizzle(elements, function);
        }
        m_Code.Erase(index - 1, last + 1);
        m_Code.Spelling(last) = ")";
        // The preprocessor leaves no blank between `return` and a bracket.
        m_Code.Spelling(first).insert(0, " " + function + "(");
    }

    /// `float2(M._m13, M._m03)`
    void SpellEach(const std::vector<std::string_view>& elements, std::size_t first,
                   std::size_t dot, std::size_t last)
    {
        const std::string operand(m_Code.Span(first, dot));
        std::string values;
        for (const std::string_view element : elements)
        {
            values.append(values.empty() ? "" : ", ").append(operand).append(".").append(element);
        }
        m_Code.Erase(first, last + 1);
        m_Code.Spelling(first) =
            elements.size() > 1 ? "float" + std::to_string(elements.size()) + "(" + values + ")"
                                : values;
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
                const bool isCall =
                    index > 0 && m_Code.isWord(index - 1) && Text(index - 1) != "return";
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
            depth -= m_Code.Step(index);
            if (depth <= 0 || index == 0)
            {
                return index;
            }
        }
    }

    HlslEditor m_Code;
    std::set<std::string> m_Known;
    std::string m_Functions;
};

} // namespace

std::string SpellMatrices(std::string text)
{
    text = SpellTemplates(std::move(text));
    text = CastSpeller(text).Spell();
    return SwizzleSpeller(text).Spell();
}

} // namespace limn
