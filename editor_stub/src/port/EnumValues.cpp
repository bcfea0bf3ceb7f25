#include "port/PortExpression.h"

#include <charconv>
#include <map>

namespace limn
{

namespace
{

/// A whole number, wrapped around as C# does where it does not check.
using Bits = std::uint64_t;
using Number = std::optional<Bits>;
using Members = std::map<std::string_view, Bits>;

constexpr int k_Shift = 4; ///< the strength of << and >>, which are two words each

/// Returns how tightly an operator of C# binds; 0 if it is no operator of whole numbers.
int EnumStrength(std::string_view word)
{
    constexpr std::string_view k_Operators = "|^&<>+-*";
    constexpr int k_Strengths[] = {1, 2, 3, k_Shift, k_Shift, 5, 5, 6};
    const std::size_t index = word.size() == 1 ? k_Operators.find(word) : word.npos;
    return index == word.npos ? 0 : k_Strengths[index];
}

Bits Apply(char operation, Bits a, Bits b)
{
    return operation == '|'   ? a | b
           : operation == '^' ? a ^ b
           : operation == '&' ? a & b
           : operation == '<' ? a << (b & 31)
           : operation == '>' ? static_cast<Bits>(static_cast<std::int64_t>(a) >> (b & 31))
           : operation == '+' ? a + b
           : operation == '-' ? a - b
                              : a * b;
}

class Evaluator
{
public:
    Evaluator(CSharpWords words, const Members& members)
        : m_At(words.data()), m_End(m_At + words.size()), m_Members(members)
    {
    }

    Number Run()
    {
        const Number number = Binary(1);
        return m_At == m_End ? number : std::nullopt;
    }

private:
    bool Next(std::string_view word)
    {
        const bool isIt = m_At < m_End && m_At->Is(word);
        m_At += isIt ? 1 : 0;
        return isIt;
    }

    Number Binary(int least)
    {
        Number left = Unary();
        while (left && m_At < m_End)
        {
            const std::string_view word = m_At->text;
            const int strength = EnumStrength(word);
            if (strength < least)
            {
                break;
            }
            ++m_At;
            if (strength == k_Shift && !Next(word))
            {
                return std::nullopt;
            }
            const Number right = Binary(strength + 1);
            left = right ? Number(Apply(word[0], *left, *right)) : std::nullopt;
        }
        return left;
    }

    /// Signs and what stands behind them; a loop, as there may be any number of them.
    Number Unary()
    {
        const CSharpToken* const first = m_At;
        while (Next("-") || Next("~"))
        {
        }
        const CSharpToken* sign = m_At;
        Number value = Operand();
        while (value && sign != first)
        {
            value = (--sign)->Is("-") ? 0 - *value : ~*value;
        }
        return value;
    }

    Number Operand()
    {
        if (Next("("))
        {
            const Number value = Binary(1);
            return Next(")") ? value : std::nullopt;
        }
        if (m_At == m_End)
        {
            return std::nullopt;
        }
        const CSharpToken& word = *m_At++;
        const auto member = m_Members.find(word.text);
        return word.isName() && member != m_Members.end() ? Number(member->second)
               : word.kind == CSharpTokenKind::Number     ? Literal(word.text)
                                                          : std::nullopt;
    }

    static Number Literal(std::string_view word)
    {
        std::string text(word);
        std::erase(text, '_');
        while (!text.empty() &&
               std::string_view("uUlL").find(text.back()) != std::string_view::npos)
        {
            text.pop_back();
        }
        const bool isHex = text.starts_with("0x") || text.starts_with("0X");
        const bool isBinary = text.starts_with("0b") || text.starts_with("0B");
        const char* begin = text.data() + (isHex || isBinary ? 2 : 0);
        const char* end = text.data() + text.size();
        std::int64_t value = 0;
        const auto read = std::from_chars(begin, end, value, isHex ? 16 : isBinary ? 2 : 10);
        return read.ec == std::errc{} && read.ptr == end ? Number(static_cast<Bits>(value))
                                                         : std::nullopt;
    }

    const CSharpToken* m_At;
    const CSharpToken* m_End;
    const Members& m_Members;
};

/// Returns the value as an enum with this base type holds it.
std::int64_t Wrapped(Bits value, const std::vector<std::string>& bases)
{
    const std::string type = bases.empty() ? "int" : bases.front();
    return type == "uint"                      ? static_cast<std::uint32_t>(value)
           : type == "long" || type == "ulong" ? static_cast<std::int64_t>(value)
                                               : static_cast<std::int32_t>(value);
}

} // namespace

std::vector<std::optional<std::int64_t>> EnumValues(const CSharpClass& one)
{
    std::vector<std::optional<std::int64_t>> values;
    Members members;
    Number next = 0;
    for (const CSharpEnumerator& entry : one.enumerators)
    {
        if (!entry.value.empty())
        {
            next = Evaluator(entry.value, members).Run();
        }
        values.push_back(next ? std::optional(Wrapped(*next, one.bases)) : std::nullopt);
        if (next)
        {
            members[entry.name] = static_cast<Bits>(*values.back());
            next = members[entry.name] + 1;
        }
    }
    return values;
}

} // namespace limn
