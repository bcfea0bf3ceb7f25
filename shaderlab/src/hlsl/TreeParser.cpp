#include "hlsl/TreeParser.h"

#include <limn/base/Text.h>
#include <limn/base/WordList.h>

#include <algorithm>

namespace limn
{

namespace
{

/// Words that end a statement or begin another one, which are no type before a name.
bool isStatementWord(std::string_view word)
{
    static const WordList s_Words(
        "return else case goto do discard break continue default if for while switch");
    return s_Words.Has(word);
}

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

HlslTreeParser::HlslTreeParser(const HlslTokens& tokens, const HlslDeclarations& declarations,
                               HlslNodes& nodes)
    : m_Tokens(tokens), m_Declarations(declarations), m_Nodes(nodes)
{
    for (const HlslStruct& type : declarations.structs)
    {
        m_TypeNames.insert(type.name);
    }
    for (const HlslVariable& alias : declarations.aliases)
    {
        m_TypeNames.insert(alias.name);
    }
}

HlslNode* HlslTreeParser::ParseBlock(std::size_t open)
{
    m_Index = open;
    m_End = m_Tokens.AfterBracket(open);
    return ReadBlock(open);
}

HlslNode* HlslTreeParser::ParseValue(std::size_t first, std::size_t end)
{
    m_Index = first;
    m_End = end;
    HlslNode* value = ReadAssignment();
    return m_Index == end ? value : ReadUnknown(first, end);
}

HlslNode* HlslTreeParser::Make(HlslNodeKind kind, std::size_t first, HlslNode* operand)
{
    HlslNode& node = m_Nodes.emplace_back();
    node.kind = kind;
    node.first = static_cast<std::uint32_t>(first);
    node.token = static_cast<std::uint32_t>(m_Index);
    node.end = static_cast<std::uint32_t>(m_Index);
    if (operand)
    {
        node.Add(operand);
    }
    return &node;
}

HlslNode* HlslTreeParser::Take(HlslNodeKind kind, std::size_t first, HlslNode* operand)
{
    HlslNode* node = Make(kind, first, operand);
    ++m_Index;
    return node;
}

HlslNode* HlslTreeParser::Close(HlslNode* node)
{
    node->end = static_cast<std::uint32_t>(std::min(m_Index, m_End));
    return node;
}

HlslNode* HlslTreeParser::ReadUnknown(std::size_t first, std::size_t end)
{
    HlslNode* node = Make(HlslNodeKind::Unknown, first);
    m_Index = end;
    return Close(node);
}

HlslNode* HlslTreeParser::ReadBlock(std::size_t first)
{
    HlslNode* block = Make(HlslNodeKind::Block, first);
    const std::size_t close = m_Tokens.AfterBracket(m_Index) - 1;
    ++m_Index;
    while (m_Index < close)
    {
        block->Add(ReadStatement());
    }
    m_Index = close + 1;
    return Close(block);
}

/// Behind the `;`, or at the bracket that ends the block.
std::size_t HlslTreeParser::EndOfStatement() const
{
    const std::size_t end = m_Tokens.FindOutside(m_Index, ";");
    return std::min(m_Tokens.Text(end) == ";" ? end + 1 : end, m_End);
}

HlslNode* HlslTreeParser::ReadStatement()
{
    const std::size_t first = m_Index;
    while (Text() == "[") // an attribute
    {
        m_Index = m_Tokens.AfterBracket(m_Index);
    }
    HlslNode* statement = Text() == "{" ? ReadBlock(first)
                          : isWord()    ? ReadWordStatement(first)
                                        : ReadSimple(first);
    if (m_Index == first)
    {
        return ReadUnknown(first, first + 1); // a bracket that nobody opened
    }
    return statement;
}

HlslNode* HlslTreeParser::ReadWordStatement(std::size_t first)
{
    const std::string_view word = Text();
    if (word == "if" || word == "while" || word == "switch")
    {
        return ReadLoop(word == "if"      ? HlslNodeKind::If
                        : word == "while" ? HlslNodeKind::While
                                          : HlslNodeKind::Switch,
                        first);
    }
    if (word == "for")
    {
        return ReadFor(first);
    }
    if (word == "do")
    {
        return ReadDo(first);
    }
    if (word == "case" || (word == "default" && Text(1) == ":"))
    {
        return ReadLabel(first);
    }
    if (word == "struct" || word == "typedef" || word == "class" || word == "enum")
    {
        const std::size_t end = EndOfStatement();
        // `struct Name { … };` or `typedef type Name;`
        m_TypeNames.insert(word == "typedef" && end > first + 2 ? m_Tokens.Text(end - 2) : Text(1));
        return ReadUnknown(first, end);
    }
    return isDeclaration() ? ReadDeclaration(first) : ReadSimple(first);
}

HlslNode* HlslTreeParser::ReadCondition()
{
    if (Text() != "(")
    {
        return ReadUnknown(m_Index, m_Index);
    }
    const std::size_t behind = m_Tokens.AfterBracket(m_Index);
    ++m_Index;
    HlslNode* condition = isDeclaration() ? ReadDeclaration(m_Index) : ReadExpression();
    if (m_Index + 1 != behind)
    {
        condition = ReadUnknown(condition->first, behind - 1);
    }
    m_Index = behind;
    return condition;
}

/// `if`, `while` and `switch`: a condition and a statement.
HlslNode* HlslTreeParser::ReadLoop(HlslNodeKind kind, std::size_t first)
{
    HlslNode* node = Take(kind, first);
    node->Add(ReadCondition());
    if (!isEnd())
    {
        node->Add(ReadStatement());
    }
    if (kind == HlslNodeKind::If && Text() == "else" && !isEnd())
    {
        ++m_Index;
        node->Add(ReadStatement());
    }
    return Close(node);
}

/// Children: declaration or expression, condition, step, statement; Empty where one is missing.
HlslNode* HlslTreeParser::ReadFor(std::size_t first)
{
    HlslNode* node = Take(HlslNodeKind::For, first);
    if (Text() != "(")
    {
        return ReadUnknown(first, EndOfStatement());
    }
    const std::size_t behind = m_Tokens.AfterBracket(m_Index);
    ++m_Index;
    for (const std::string_view mark : {";", ";", ")"})
    {
        HlslNode* part = Text() == mark    ? Close(Make(HlslNodeKind::Empty, m_Index))
                         : isDeclaration() ? ReadDeclaration(m_Index)
                                           : ReadExpression();
        const bool isDeclared = part->kind == HlslNodeKind::Declaration;
        m_Index += !isDeclared && Text() == mark ? 1 : 0;
        node->Add(part);
    }
    if (m_Index != behind)
    {
        m_Index = behind;
        return ReadUnknown(first, EndOfStatement());
    }
    node->Add(ReadStatement());
    return Close(node);
}

HlslNode* HlslTreeParser::ReadDo(std::size_t first)
{
    HlslNode* node = Take(HlslNodeKind::Do, first);
    node->Add(ReadStatement());
    if (Text() == "while")
    {
        ++m_Index;
        node->Add(ReadCondition());
    }
    m_Index += Text() == ";" ? 1 : 0;
    return Close(node);
}

HlslNode* HlslTreeParser::ReadLabel(std::size_t first)
{
    const bool isCase = Text() == "case";
    HlslNode* node = Take(HlslNodeKind::Label, first);
    if (isCase)
    {
        node->Add(ReadExpression());
    }
    m_Index += Text() == ":" ? 1 : 0;
    return Close(node);
}

/// `return x;`, `x = y;`, `break;`, `;`
HlslNode* HlslTreeParser::ReadSimple(std::size_t first)
{
    const bool isReturn = Text() == "return";
    HlslNode* node = Make(isReturn ? HlslNodeKind::Return : HlslNodeKind::Expression, first);
    const bool isJump = Text() == "break" || Text() == "continue" || Text() == "discard";
    m_Index += isReturn || isJump ? 1 : 0;
    const std::size_t end = EndOfStatement();
    const std::size_t mark = end > first && m_Tokens.Text(end - 1) == ";" ? end - 1 : end;
    if (m_Index < mark)
    {
        HlslNode* value = ReadExpression();
        node->Add(m_Index == mark ? value : ReadUnknown(value->first, mark));
    }
    m_Index = end;
    return Close(node);
}

/// Returns whether a declaration begins at the index: modifiers, or a type and a name.
bool HlslTreeParser::isDeclaration() const
{
    std::size_t index = m_Index;
    while (m_Tokens.isWord(index) && isTypeModifier(m_Tokens.Text(index)) &&
           m_Tokens.isWord(index + 1))
    {
        ++index;
    }
    HlslType type;
    const std::size_t behind = ReadType(index, type);
    return behind != 0 && m_Tokens.isWord(behind) && !isStatementWord(m_Tokens.Text(index));
}

HlslNode* HlslTreeParser::ReadDeclaration(std::size_t first)
{
    HlslNode* node = Make(HlslNodeKind::Declaration, first);
    while (isTypeModifier(Text()) && isWord(1))
    {
        ++m_Index;
    }
    node->token = static_cast<std::uint32_t>(m_Index);
    HlslType type;
    const bool isKnown = Text() == "struct" || isTypeName(m_Index) || Text(1) == "::";
    if (!isKnown)
    {
        m_UnknownTypes.push_back(m_Index);
    }
    m_Index = ReadType(m_Index, type);
    const std::size_t end = EndOfStatement();
    while (m_Index < end)
    {
        node->Add(ReadDeclarator(type));
        if (Text() != ",")
        {
            break;
        }
        ++m_Index;
    }
    m_Index += Text() == ";" && m_Index < end ? 1 : 0;
    if (m_Index < end && Text() != ")")
    {
        ReadUnknown(m_Index, end);
    }
    return Close(node);
}

HlslNode* HlslTreeParser::ReadDeclarator(HlslType type)
{
    HlslNode* node = Take(HlslNodeKind::Declarator, m_Index);
    for (; Text() == "["; m_Index = m_Tokens.AfterBracket(m_Index))
    {
        ++type.dimensions;
    }
    node->type = type;
    if (Text() == "=")
    {
        ++m_Index;
        HlslNode* value = ReadAssignment();
        if (isWord() && m_Tokens.Text(m_Index - 1) != ")") // `(type)word` may be of a type unknown
        {
            m_Unended.push_back({m_Index, std::string(k_MissingSemicolon)});
        }
        const bool isWhole = Text() == "," || Text() == ";" || Text() == ")";
        node->Add(isWhole ? value
                          : ReadUnknown(value->first,
                                        std::min(m_Tokens.FindOutside(m_Index, ";"), m_End)));
    }
    return Close(node);
}

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
    const bool isTernary = Text() == "?";
    if (isEnd() || (!isTernary && !isAssignment(Text())))
    {
        return left;
    }
    HlslNode* node =
        Take(isTernary ? HlslNodeKind::Ternary : HlslNodeKind::Assign, left->first, left);
    node->Add(ReadAssignment());
    if (isTernary && Text() == ":")
    {
        ++m_Index;
        node->Add(ReadAssignment());
    }
    return Close(node);
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
            HlslNode* node = Make(HlslNodeKind::Cast, m_Index);
            node->type = type;
            m_Index = m_Tokens.AfterBracket(m_Index);
            node->Add(ReadPrefix());
            return Close(node);
        }
    }
    return ReadPostfix();
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
