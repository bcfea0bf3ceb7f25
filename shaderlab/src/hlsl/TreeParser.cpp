#include "hlsl/TreeParser.h"

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

} // namespace

HlslTreeParser::HlslTreeParser(const HlslTokens& tokens, const HlslDeclarations& declarations,
                               HlslNodes& nodes)
    : m_Tokens(tokens), m_Declarations(declarations), m_Nodes(nodes)
{
    for (const HlslStruct& type : declarations.structs)
    {
        m_TypeNames.insert(type.name);
    }
    for (const HlslAlias& alias : declarations.aliases)
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

void HlslTreeParser::SkipAttributes()
{
    while (Text() == "[")
    {
        m_Index = m_Tokens.AfterBracket(m_Index);
    }
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
    SkipAttributes();
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

} // namespace limn
