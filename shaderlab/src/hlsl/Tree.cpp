#include "hlsl/Tree.h"

#include "text/Text.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace limn
{

namespace
{

constexpr std::array<std::string_view, 11> k_Assignments = {
    "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="};

/// 0 = no operator between two values.
int PrecedenceOf(std::string_view text)
{
    constexpr std::pair<std::string_view, int> k_Precedences[] = {
        {"||", 1}, {"&&", 2}, {"|", 3}, {"^", 4},  {"&", 5},  {"==", 6},
        {"!=", 6}, {"<", 7},  {">", 7}, {"<=", 7}, {">=", 7}, {"<<", 8},
        {">>", 8}, {"+", 9},  {"-", 9}, {"*", 10}, {"/", 10}, {"%", 10}};
    const auto* const found = std::find_if(std::begin(k_Precedences), std::end(k_Precedences),
                                           [&](const auto& item) { return item.first == text; });
    return found == std::end(k_Precedences) ? 0 : found->second;
}

bool isAssignment(std::string_view text)
{
    return std::find(k_Assignments.begin(), k_Assignments.end(), text) != k_Assignments.end();
}

bool isPrefix(std::string_view text)
{
    return text == "-" || text == "+" || text == "!" || text == "~" || text == "++" || text == "--";
}

bool isNumber(std::string_view text)
{
    return !text.empty() && (isDigit(text[0]) || (text[0] == '.' && text.size() > 1));
}

HlslType LiteralType(std::string_view text)
{
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
    constexpr std::string_view k_Words[] = {"sampler", "texture", "matrix", "vector"};
    return std::find(std::begin(k_Words), std::end(k_Words), word) != std::end(k_Words);
}

/// Words that end a statement or begin another one, which are no type before a name.
bool isStatementWord(std::string_view word)
{
    constexpr std::string_view k_Words[] = {"return",  "else",  "case",     "goto",    "do",
                                            "discard", "break", "continue", "default", "if",
                                            "for",     "while", "switch"};
    return std::find(std::begin(k_Words), std::end(k_Words), word) != std::end(k_Words);
}

} // namespace

HlslNode* HlslNode::Child(std::size_t index) const
{
    HlslNode* node = child;
    for (; node && index > 0; --index)
    {
        node = node->next;
    }
    return node;
}

std::size_t HlslNode::CountChildren() const
{
    std::size_t count = 0;
    for (const HlslNode* node = child; node; node = node->next)
    {
        ++count;
    }
    return count;
}

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

HlslNode* HlslTreeParser::Make(HlslNodeKind kind, std::size_t first)
{
    HlslNode& node = m_Nodes.emplace_back();
    node.kind = kind;
    node.first = static_cast<std::uint32_t>(first);
    node.token = static_cast<std::uint32_t>(m_Index);
    node.end = static_cast<std::uint32_t>(m_Index);
    return &node;
}

HlslNode* HlslTreeParser::Close(HlslNode* node)
{
    node->end = static_cast<std::uint32_t>(std::min(m_Index, m_End));
    return node;
}

void HlslTreeParser::Add(HlslNode* parent, HlslNode* child)
{
    child->parent = parent;
    HlslNode** link = &parent->child;
    while (*link)
    {
        link = &(*link)->next;
    }
    *link = child;
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
    HlslNode* last = nullptr;
    for (++m_Index; m_Index < close;)
    {
        HlslNode* statement = ReadStatement();
        statement->parent = block; // Add() would walk the whole list each time
        (last ? last->next : block->child) = statement;
        last = statement;
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
        return ReadUnknown(first, EndOfStatement());
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
    HlslNode* node = Make(kind, first);
    ++m_Index;
    Add(node, ReadCondition());
    if (!isEnd())
    {
        Add(node, ReadStatement());
    }
    if (kind == HlslNodeKind::If && Text() == "else" && !isEnd())
    {
        ++m_Index;
        Add(node, ReadStatement());
    }
    return Close(node);
}

/// Children: declaration or expression, condition, step, statement; Empty where one is missing.
HlslNode* HlslTreeParser::ReadFor(std::size_t first)
{
    HlslNode* node = Make(HlslNodeKind::For, first);
    ++m_Index;
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
        Add(node, part);
    }
    if (m_Index != behind)
    {
        m_Index = behind;
        return ReadUnknown(first, EndOfStatement());
    }
    Add(node, ReadStatement());
    return Close(node);
}

HlslNode* HlslTreeParser::ReadDo(std::size_t first)
{
    HlslNode* node = Make(HlslNodeKind::Do, first);
    ++m_Index;
    Add(node, ReadStatement());
    if (Text() == "while")
    {
        ++m_Index;
        Add(node, ReadCondition());
    }
    m_Index += Text() == ";" ? 1 : 0;
    return Close(node);
}

HlslNode* HlslTreeParser::ReadLabel(std::size_t first)
{
    HlslNode* node = Make(HlslNodeKind::Label, first);
    if (Text(0) == "case")
    {
        ++m_Index;
        Add(node, ReadExpression());
    }
    else
    {
        ++m_Index;
    }
    m_Index += Text() == ":" ? 1 : 0;
    return Close(node);
}

/// `return x;`, `x = y;`, `break;`, `;`
HlslNode* HlslTreeParser::ReadSimple(std::size_t first)
{
    const bool isReturn = Text() == "return";
    HlslNode* node = Make(isReturn ? HlslNodeKind::Return : HlslNodeKind::Expression, first);
    m_Index += isReturn ? 1 : 0;
    const std::size_t end = EndOfStatement();
    const std::size_t mark = end > first && m_Tokens.Text(end - 1) == ";" ? end - 1 : end;
    if (m_Index < mark)
    {
        HlslNode* value = ReadExpression();
        Add(node, m_Index == mark ? value : ReadUnknown(value->first, mark));
    }
    m_Index = end;
    return Close(node);
}

/// Whether a declaration begins at the index: modifiers, or a type and a name.
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
    m_Index = ReadType(m_Index, type);
    const std::size_t end = EndOfStatement();
    while (m_Index < end)
    {
        Add(node, ReadDeclarator(type));
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
    HlslNode* node = Make(HlslNodeKind::Declarator, m_Index);
    ++m_Index;
    for (; Text() == "["; m_Index = m_Tokens.AfterBracket(m_Index))
    {
        ++type.dimensions;
    }
    node->type = type;
    if (Text() == "=")
    {
        ++m_Index;
        HlslNode* value = ReadAssignment();
        const bool isWhole = Text() == "," || Text() == ";" || Text() == ")";
        Add(node, isWhole ? value
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
        HlslNode* node = Make(HlslNodeKind::Binary, left->first);
        ++m_Index;
        Add(node, left);
        Add(node, ReadAssignment());
        left = Close(node);
    }
    return left;
}

HlslNode* HlslTreeParser::ReadAssignment()
{
    HlslNode* left = ReadBinary(1);
    if (Text() == "?" && !isEnd())
    {
        HlslNode* node = Make(HlslNodeKind::Ternary, left->first);
        ++m_Index;
        Add(node, left);
        Add(node, ReadAssignment());
        if (Text() == ":")
        {
            ++m_Index;
            Add(node, ReadAssignment());
        }
        left = Close(node);
    }
    else if (isAssignment(Text()) && !isEnd())
    {
        HlslNode* node = Make(HlslNodeKind::Assign, left->first);
        ++m_Index;
        Add(node, left);
        Add(node, ReadAssignment());
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
        if (own < precedence || own == 0)
        {
            break;
        }
        HlslNode* node = Make(HlslNodeKind::Binary, left->first);
        ++m_Index;
        Add(node, left);
        Add(node, ReadBinary(own + 1));
        left = Close(node);
    }
    return left;
}

HlslNode* HlslTreeParser::ReadPrefix()
{
    if (isPrefix(Text()) && !isEnd())
    {
        HlslNode* node = Make(HlslNodeKind::Prefix, m_Index);
        ++m_Index;
        Add(node, ReadPrefix());
        return Close(node);
    }
    if (Text() == "(" && !isEnd())
    {
        HlslType type;
        const std::size_t behind = ReadType(m_Index + 1, type);
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
    ReadType(m_Index + 1, node->type);
    m_Index = behind;
    Add(node, ReadPrefix());
    return Close(node);
}

HlslNode* HlslTreeParser::ReadPostfix()
{
    HlslNode* value = ReadPrimary();
    while (!isEnd())
    {
        const std::string_view text = Text();
        HlslNode* node = nullptr;
        if (text == "." && isWord(1))
        {
            ++m_Index;
            node = Make(Text(1) == "(" ? HlslNodeKind::Method : HlslNodeKind::Member, value->first);
            Add(node, value);
            ++m_Index;
            value = node->kind == HlslNodeKind::Method ? ReadArguments(node, ")") : Close(node);
        }
        else if (text == "[")
        {
            node = Make(HlslNodeKind::Index, value->first);
            Add(node, value);
            value = ReadArguments(node, "]");
        }
        else if (text == "++" || text == "--")
        {
            node = Make(HlslNodeKind::Postfix, value->first);
            Add(node, value);
            ++m_Index;
            value = Close(node);
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
        Add(node, m_Index == comma ? argument : ReadUnknown(argument->first, comma));
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
        HlslNode* node = Make(HlslNodeKind::Paren, first);
        ++m_Index;
        HlslNode* value = ReadExpression();
        Add(node, m_Index + 1 == behind ? value : ReadUnknown(value->first, behind - 1));
        m_Index = behind;
        return Close(node);
    }
    if (isNumber(Text()))
    {
        HlslNode* node = Make(HlslNodeKind::Literal, first);
        node->type = LiteralType(Text());
        ++m_Index;
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
    if (Text() == "true" || Text() == "false")
    {
        HlslNode* node = Make(HlslNodeKind::Literal, first);
        node->type = HlslType::Number(HlslScalar::Bool);
        ++m_Index;
        return Close(node);
    }
    m_Index += Text(1) == "::" ? 2 : 0; // `Type::Method(…)`
    HlslNode* node = Make(Text(1) == "(" ? HlslNodeKind::Call : HlslNodeKind::Name, first);
    m_Index += isEnd() ? 0 : 1;
    return node->kind == HlslNodeKind::Call ? ReadArguments(node, ")") : Close(node);
}

bool HlslTreeParser::isOperand(std::size_t index) const
{
    const std::string_view text = m_Tokens.Text(index);
    // Of a name in brackets and a sign: `(matrix) - x`.
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

HlslType TypeOf(const HlslDeclarations& declarations, std::string_view type,
                std::string_view argument)
{
    type = declarations.ResolveAlias(type, &argument);
    if (type == "void")
    {
        HlslType result;
        result.kind = HlslType::Kind::Void;
        return result;
    }
    if ((type == "vector" || type == "matrix") && !argument.empty())
    {
        const auto scalar = NumberType(Trim(argument.substr(0, argument.find(','))));
        const auto size = [&](std::size_t comma)
        {
            const std::string_view text =
                comma == argument.npos ? "" : Trim(argument.substr(comma + 1));
            return text.empty() || !isDigit(text[0]) ? 0 : text[0] - '0';
        };
        const int first = size(argument.find(','));
        const int second = size(argument.rfind(','));
        const bool isKnown = scalar && first > 0 && second > 0;
        return !isKnown           ? HlslType()
               : type == "vector" ? scalar->As(first)
                                  : scalar->As(second, first);
    }
    if (const auto number = NumberType(type))
    {
        return *number;
    }
    HlslType result;
    const HlslStruct* structure = declarations.FindStruct(type);
    if (structure || isObjectType(type))
    {
        result.kind = structure ? HlslType::Kind::Struct : HlslType::Kind::Object;
        result.name = type;
        result.element = argument;
    }
    return result;
}

HlslType TypeOf(const HlslDeclarations& declarations, const HlslVariable& variable)
{
    HlslType type = TypeOf(declarations, variable.type, variable.templateArgument);
    type.dimensions = static_cast<std::uint8_t>(variable.dimensions.size());
    return type;
}

} // namespace limn
