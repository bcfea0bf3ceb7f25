#include "tokens/IntegerExpression.h"

#include "tokens/Tokens.h"

#include <cstdlib>

namespace limn
{

namespace
{

/// Wraps around like the machine does: whatever a file holds has a value.
std::int64_t Calculate(std::string_view operation, std::int64_t left, std::int64_t right)
{
    const auto a = static_cast<std::uint64_t>(left);
    const auto b = static_cast<std::uint64_t>(right);
    const bool divides = right != 0 && right != -1;
    switch (operation[0])
    {
    case '|':
        return operation == "||" ? (left || right) : static_cast<std::int64_t>(a | b);
    case '&':
        return operation == "&&" ? (left && right) : static_cast<std::int64_t>(a & b);
    case '^':
        return static_cast<std::int64_t>(a ^ b);
    case '=':
        return left == right;
    case '!':
        return left != right;
    case '<':
        return operation == "<"    ? left < right
               : operation == "<=" ? left <= right
                                   : static_cast<std::int64_t>(a << (b & 63));
    case '>':
        return operation == ">"    ? left > right
               : operation == ">=" ? left >= right
                                   : static_cast<std::int64_t>(a >> (b & 63));
    case '+':
        return static_cast<std::int64_t>(a + b);
    case '-':
        return static_cast<std::int64_t>(a - b);
    case '*':
        return static_cast<std::int64_t>(a * b);
    case '/':
        return divides ? left / right : static_cast<std::int64_t>(right == 0 ? 0 : 0 - a);
    default:
        return divides ? left % right : 0;
    }
}

/// The value of an `#if` expression. Unknown names are 0, as in C; so is what makes no sense, for
/// the preprocessor of the compiler reports that.
class Expression
{
public:
    Expression(std::string_view text, const IntegerNames& macros, int& budget)
        : m_Tokens(TokenizeHlsl(text)), m_Macros(macros), m_Budget(budget)
    {
    }

    std::int64_t Value() { return Binary(1); }

private:
    std::string_view Text() const
    {
        return m_Index < m_Tokens.size() ? m_Tokens[m_Index].text : std::string_view();
    }
    bool Accept(std::string_view text)
    {
        const bool accepted = !text.empty() && Text() == text;
        m_Index += accepted ? 1 : 0;
        return accepted;
    }

    std::int64_t Binary(int lowest)
    {
        std::int64_t left = Unary();
        for (int precedence; (precedence = PrecedenceOf(Text())) >= lowest;)
        {
            const std::string_view operation = m_Tokens[m_Index++].text;
            left = Calculate(operation, left, Binary(precedence + 1));
        }
        return left;
    }

    std::int64_t Unary()
    {
        // Bounds both nesting and macros that name each other again and again.
        if (--m_Budget < 0 || m_Index >= m_Tokens.size())
        {
            return 0;
        }
        const char sign = m_Tokens[m_Index].Mark();
        if (std::string_view("!-+~").find(sign) != std::string_view::npos)
        {
            ++m_Index;
            const std::int64_t value = Unary();
            return sign == '!'   ? value == 0
                   : sign == '-' ? Calculate("-", 0, value)
                   : sign == '~' ? ~value
                                 : value;
        }
        if (Accept("("))
        {
            const std::int64_t value = Binary(1);
            Accept(")");
            return value;
        }
        return Accept("defined") ? Defined() : Operand();
    }

    std::int64_t Defined()
    {
        const bool inBrackets = Accept("(");
        const bool defined = m_Macros.find(Text()) != m_Macros.end();
        ++m_Index;
        if (inBrackets)
        {
            Accept(")");
        }
        return defined;
    }

    std::int64_t Operand()
    {
        const HlslToken token = m_Tokens[m_Index++];
        if (!token.isWord)
        {
            return static_cast<std::int64_t>(
                std::strtoull(std::string(token.text).c_str(), nullptr, 0));
        }
        const auto macro = m_Macros.find(token.text);
        return macro == m_Macros.end() ? 0 : Expression(macro->second, m_Macros, m_Budget).Value();
    }

    const std::vector<HlslToken> m_Tokens;
    const IntegerNames& m_Macros;
    int& m_Budget;
    std::size_t m_Index = 0;
};

} // namespace

std::int64_t EvaluateInteger(std::string_view expression, const IntegerNames& names)
{
    int budget = 1000;
    return Expression(expression, names, budget).Value();
}

} // namespace limn
