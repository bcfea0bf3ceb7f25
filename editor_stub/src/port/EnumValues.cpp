#include "port/PortExpression.h"

#include <algorithm>
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

struct Operator
{
    std::string_view word;
    int strength; ///< how tightly it binds
    Bits (*apply)(Bits, Bits);
};

constexpr int k_Shift = 4; ///< the strength of << and >>, which are two words each
constexpr Operator k_Operators[] = {{"|", 1,
                                     [](Bits a, Bits b)
                                     {
                                         return a | b;
                                     }},
                                    {"^", 2,
                                     [](Bits a, Bits b)
                                     {
                                         return a ^ b;
                                     }},
                                    {"&", 3,
                                     [](Bits a, Bits b)
                                     {
                                         return a & b;
                                     }},
                                    {"<", k_Shift,
                                     [](Bits a, Bits b)
                                     {
                                         return a << (b & 31);
                                     }},
                                    {">", k_Shift,
                                     [](Bits a, Bits b)
                                     {
                                         return static_cast<Bits>(static_cast<std::int64_t>(a) >>
                                                                  (b & 31));
                                     }},
                                    {"+", 5,
                                     [](Bits a, Bits b)
                                     {
                                         return a + b;
                                     }},
                                    {"-", 5,
                                     [](Bits a, Bits b)
                                     {
                                         return a - b;
                                     }},
                                    {"*", 6,
                                     [](Bits a, Bits b)
                                     {
                                         return a * b;
                                     }}};

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
            const auto* known = std::ranges::find(k_Operators, m_At->text, &Operator::word);
            if (known == std::end(k_Operators) || known->strength < least)
            {
                break;
            }
            ++m_At;
            if (known->strength == k_Shift && !Next(known->word))
            {
                return std::nullopt;
            }
            const Number right = Binary(known->strength + 1);
            left = right ? Number(known->apply(*left, *right)) : std::nullopt;
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
