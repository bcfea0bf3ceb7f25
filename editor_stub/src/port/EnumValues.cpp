#include "port/PortExpression.h"

#include <charconv>
#include <map>

namespace limn
{

namespace
{

using Number = std::optional<std::int64_t>;
using Members = std::map<std::string_view, std::int64_t>;

/// Returns how tightly an operator of C# binds; 0 if it is no operator of whole numbers.
int EnumStrength(std::string_view word)
{
    return word == "|"   ? 1
           : word == "^" ? 2
           : word == "&" ? 3
           : word == "<" ? 4 // << and >>, each two words
           : word == ">" ? 4
           : word == "+" ? 5
           : word == "-" ? 5
           : word == "*" ? 6
                         : 0;
}

/// Wraps around as C# does where it does not check.
Number Apply(std::string_view word, std::int64_t left, std::int64_t right)
{
    const auto a = static_cast<std::uint64_t>(left);
    const auto b = static_cast<std::uint64_t>(right);
    switch (word[0])
    {
    case '|':
        return left | right;
    case '^':
        return left ^ right;
    case '&':
        return left & right;
    case '<':
        return static_cast<std::int64_t>(a << (b & 31));
    case '>':
        return left >> (b & 31);
    case '+':
        return static_cast<std::int64_t>(a + b);
    case '-':
        return static_cast<std::int64_t>(a - b);
    default:
        return static_cast<std::int64_t>(a * b);
    }
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
            if (strength < least || strength == 0)
            {
                break;
            }
            ++m_At;
            if (strength == EnumStrength("<") && !Next(word))
            {
                return std::nullopt;
            }
            const Number right = Binary(strength + 1);
            left = right ? Apply(word, *left, *right) : std::nullopt;
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
            value = (--sign)->Is("-") ? Apply("-", 0, *value) : ~*value;
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
        return read.ec == std::errc{} && read.ptr == end ? Number(value) : std::nullopt;
    }

    const CSharpToken* m_At;
    const CSharpToken* m_End;
    const Members& m_Members;
};

/// Returns the value as an enum with this base type holds it.
std::int64_t Wrapped(std::int64_t value, const std::vector<std::string>& bases)
{
    const std::string type = bases.empty() ? "int" : bases.front();
    return type == "uint"    ? static_cast<std::int64_t>(static_cast<std::uint32_t>(value))
           : type == "long"  ? value
           : type == "ulong" ? value
                             : static_cast<std::int64_t>(static_cast<std::int32_t>(value));
}

} // namespace

std::vector<std::optional<std::int64_t>> EnumValues(const CSharpClass& one)
{
    std::vector<std::optional<std::int64_t>> values;
    Members members;
    std::optional<std::int64_t> next = 0;
    for (const CSharpEnumerator& entry : one.enumerators)
    {
        if (!entry.value.empty())
        {
            next = Evaluator(entry.value, members).Run();
        }
        next = next ? Number(Wrapped(*next, one.bases)) : next;
        values.push_back(next);
        if (next)
        {
            members[entry.name] = *next;
            next = Apply("+", *next, 1);
        }
    }
    return values;
}

} // namespace limn
