#include "hlsl/TreeParser.h"

#include <limn/base/Text.h>
#include <limn/base/WordList.h>

#include <algorithm>

namespace limn
{

namespace
{

bool isAssignment(std::string_view text)
{
    static const WordList s_Assignments("= += -= *= /= %= &= |= ^= <<= >>=");
    return s_Assignments.Has(text);
}

bool isPrefix(std::string_view text)
{
    return text == "-" || text == "+" || text == "!" || text == "~" || text == "++" || text == "--";
}

bool isNumber(std::string_view text)
{
    return !text.empty() && (isDigit(text[0]) || (text[0] == '.' && text.size() > 1));
}

bool isTruth(std::string_view text)
{
    return text == "true" || text == "false";
}

HlslType LiteralType(std::string_view text)
{
    if (isTruth(text))
    {
        return HlslType::Number(HlslScalar::Bool);
    }
    const bool isHexadecimal = text.starts_with("0x") || text.starts_with("0X");
    const char suffix = ToLower(text.back());
    if (!isHexadecimal && (suffix == 'f' || suffix == 'h'))
    {
        return HlslType::Number(suffix == 'f' ? HlslScalar::Float : HlslScalar::Half);
    }
    if (!isHexadecimal && text.find_first_of(".eE#") != text.npos)
    {
        return HlslType::Number(HlslScalar::Literal);
    }
    return HlslType::Number(suffix == 'u' ? HlslScalar::Uint : HlslScalar::Int);
}

/// Words that may stand for a name where no type follows: `float4x4 matrix`.
bool isNameToo(std::string_view word)
{
    return word == "sampler" || word == "texture" || word == "matrix" || word == "vector";
}

} // namespace

HlslNode* HlslTreeParser::ReadExpression()
{
    HlslNode* left = ReadAssignment();
    while (Text() == "," && !isEnd())
    {
        HlslNode* node = Take(HlslNodeKind::Binary, left->first, left);
        node->Add(ReadAssignment());
        left = Close(node);
    }
    return left;
}

HlslNode* HlslTreeParser::ReadAssignment()
{
    HlslNode* left = ReadBinary(1);
    if (Text() == "?" && !isEnd())
    {
        HlslNode* node = Take(HlslNodeKind::Ternary, left->first, left);
        node->Add(ReadAssignment());
        if (Text() == ":")
        {
            ++m_Index;
            node->Add(ReadAssignment());
        }
        left = Close(node);
    }
    else if (isAssignment(Text()) && !isEnd())
    {
        HlslNode* node = Take(HlslNodeKind::Assign, left->first, left);
        node->Add(ReadAssignment());
        left = Close(node);
    }
    return left;
}

HlslNode* HlslTreeParser::ReadBinary(int precedence)
{
    HlslNode* left = ReadPrefix();
    while (!isEnd())
    {
        const int own = PrecedenceOf(Text());
        if (own < precedence)
        {
            break;
        }
        HlslNode* node = Take(HlslNodeKind::Binary, left->first, left);
        node->Add(ReadBinary(own + 1));
        left = Close(node);
    }
    return left;
}

HlslNode* HlslTreeParser::ReadPrefix()
{
    if (isPrefix(Text()) && !isEnd())
    {
        HlslNode* node = Take(HlslNodeKind::Prefix, m_Index);
        node->Add(ReadPrefix());
        return Close(node);
    }
    if (Text() == "(" && !isEnd())
    {
        HlslType type;
        const std::size_t behind = ReadArrayType(m_Index + 1, type);
        if (behind != 0 && m_Tokens.Text(behind) == ")" && isTypeName(m_Index + 1) &&
            isOperand(behind + 1))
        {
            return ReadCast();
        }
    }
    return ReadPostfix();
}

HlslNode* HlslTreeParser::ReadCast()
{
    HlslNode* node = Make(HlslNodeKind::Cast, m_Index);
    const std::size_t behind = m_Tokens.AfterBracket(m_Index);
    ReadArrayType(m_Index + 1, node->type);
    m_Index = behind;
    node->Add(ReadPrefix());
    return Close(node);
}

HlslNode* HlslTreeParser::ReadPostfix()
{
    HlslNode* value = ReadPrimary();
    while (!isEnd())
    {
        const std::string_view text = Text();
        if (text == "." && isWord(1))
        {
            ++m_Index;
            const bool isMethod = Text(1) == "(";
            value =
                Take(isMethod ? HlslNodeKind::Method : HlslNodeKind::Member, value->first, value);
            value = isMethod ? ReadArguments(value, ")") : Close(value);
        }
        else if (text == "[")
        {
            value = ReadArguments(Make(HlslNodeKind::Index, value->first, value), "]");
        }
        else if (text == "++" || text == "--")
        {
            value = Close(Take(HlslNodeKind::Postfix, value->first, value));
        }
        else
        {
            break;
        }
    }
    return value;
}

/// From the opening bracket on.
HlslNode* HlslTreeParser::ReadArguments(HlslNode* node, std::string_view close)
{
    const std::size_t behind = m_Tokens.AfterBracket(m_Index);
    const std::size_t last = m_Tokens.Text(behind - 1) == close ? behind - 1 : behind;
    ++m_Index;
    while (m_Index < last && !isEnd())
    {
        HlslNode* argument = ReadAssignment();
        const std::size_t comma = std::min(m_Tokens.FindOutside(m_Index, ","), last);
        node->Add(m_Index == comma ? argument : ReadUnknown(argument->first, comma));
        m_Index = comma + (comma < last ? 1 : 0);
    }
    m_Index = behind;
    return Close(node);
}

HlslNode* HlslTreeParser::ReadPrimary()
{
    const std::size_t first = m_Index;
    if (isEnd())
    {
        return ReadUnknown(first, first);
    }
    if (Text() == "{")
    {
        return ReadArguments(Make(HlslNodeKind::List, first), "}");
    }
    if (Text() == "(")
    {
        const std::size_t behind = m_Tokens.AfterBracket(m_Index);
        HlslNode* node = Take(HlslNodeKind::Paren, first);
        HlslNode* value = ReadExpression();
        node->Add(m_Index + 1 == behind ? value : ReadUnknown(value->first, behind - 1));
        m_Index = behind;
        return Close(node);
    }
    if (isNumber(Text()) || isTruth(Text()))
    {
        HlslNode* node = Take(HlslNodeKind::Literal, first);
        node->type = LiteralType(m_Tokens.Text(first));
        return Close(node);
    }
    if (!isWord())
    {
        return ReadUnknown(first, first); // whoever asked skips what is here
    }
    HlslType type;
    const std::size_t behind = isTypeName(first) ? ReadType(first, type) : 0;
    if (behind != 0 && m_Tokens.Text(behind) == "(")
    {
        HlslNode* node = Make(HlslNodeKind::Construct, first);
        node->type = type;
        m_Index = behind;
        return ReadArguments(node, ")");
    }
    m_Index += Text(1) == "::" ? 2 : 0; // `Type::Method(…)`
    HlslNode* node = Make(Text(1) == "(" ? HlslNodeKind::Call : HlslNodeKind::Name, first);
    m_Index += isEnd() ? 0 : 1;
    return node->kind == HlslNodeKind::Call ? ReadArguments(node, ")") : Close(node);
}

bool HlslTreeParser::isOperand(std::size_t index) const
{
    const std::string_view text = m_Tokens.Text(index);
    // A sign behind a name in brackets is no cast: `(matrix) - x`.
    const bool isSign = isPrefix(text) && text != "++" && text != "--";
    return m_Tokens.isWord(index) || text == "(" || isNumber(text) ||
           (isSign && !isNameToo(m_Tokens.Text(index - 2)));
}

bool HlslTreeParser::isTypeName(std::size_t index) const
{
    const std::string_view word = m_Tokens.Text(index);
    return NumberType(word) || word == "struct" || word == "unsigned" || word == "void" ||
           isObjectType(word) || m_TypeNames.contains(word);
}

std::size_t HlslTreeParser::ReadType(std::size_t index, HlslType& type) const
{
    index += m_Tokens.Text(index) == "struct" || m_Tokens.Text(index) == "const" ? 1 : 0;
    if (!m_Tokens.isWord(index))
    {
        return 0;
    }
    if (m_Tokens.Text(index) == "unsigned")
    {
        type = HlslType::Number(HlslScalar::Uint);
        return m_Tokens.Text(index + 1) == "int" ? index + 2 : index + 1;
    }
    const std::string_view word = m_Tokens.Text(index);
    std::string_view argument;
    std::size_t behind = index + 1;
    if (m_Tokens.Text(behind) == "<" && isTypeName(index))
    {
        std::size_t close = behind + 1;
        while (close < m_Tokens.size() && !m_Tokens.Text(close).starts_with(">") &&
               m_Tokens.Text(close) != ";")
        {
            ++close;
        }
        argument = m_Tokens.Span(behind + 1, close);
        behind = close + 1;
    }
    type = TypeOf(m_Declarations, word, argument);
    return behind;
}

std::size_t HlslTreeParser::ReadArrayType(std::size_t index, HlslType& type) const
{
    index = ReadType(index, type);
    for (; index != 0 && m_Tokens.Text(index) == "["; index = m_Tokens.AfterBracket(index))
    {
        ++type.dimensions;
    }
    return index;
}

} // namespace limn
