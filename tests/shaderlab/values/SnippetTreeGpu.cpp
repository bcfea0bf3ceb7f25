#include "values/Snippet.h"

#include <algorithm>
#include <array>
#include <sstream>

// Types, and how a snippet is written.

namespace limn::test::snippets
{

namespace
{

constexpr std::array k_Names = {"bool", "min16int", "int", "uint", "half", "min16float", "float"};

/// How tightly what the node is binds.
int LevelOf(const Node& node)
{
    static const std::map<std::string, int> s_Levels = {
        {"||", 3},  {"&&", 4}, {"|", 5},  {"^", 6},  {"&", 7},  {"==", 8},
        {"!=", 8},  {"<", 9},  {"<=", 9}, {">", 9},  {">=", 9}, {"<<", 10},
        {">>", 10}, {"+", 11}, {"-", 11}, {"*", 12}, {"/", 12}, {"%", 12}};
    switch (node.kind)
    {
    case Kind::Assign:
        return 1;
    case Kind::Ternary:
        return 2;
    case Kind::Binary:
        return s_Levels.at(node.text);
    case Kind::Prefix:
    case Kind::Cast:
        return 13;
    case Kind::Number:
        return node.number < 0.0 ? 13 : 15;
    default:
        return 15;
    }
}

std::string Sizes(const Type& type)
{
    std::string text;
    for (const int size : type.sizes)
    {
        text += "[" + std::to_string(size) + "]";
    }
    return text;
}

std::string Literal(const Node& node)
{
    std::ostringstream text;
    text << node.number;
    std::string digits = text.str();
    if (isFloating(node.type.scalar) && digits.find('.') == digits.npos)
    {
        digits += ".0";
    }
    switch (node.type.scalar)
    {
    case Scalar::Bool:
        return node.number != 0.0 ? "true" : "false";
    case Scalar::Uint:
        return digits + "u";
    case Scalar::Half:
        return digits + "h";
    default:
        return digits + node.text;
    }
}

std::string Join(const std::vector<Node>& nodes, const std::string& open, const std::string& close)
{
    std::string text = open;
    for (const Node& node : nodes)
    {
        text += (&node == &nodes.front() ? "" : ", ") + Print(node, 2);
    }
    return text + close;
}

std::string PrintPlain(const Node& node)
{
    const auto child = [&](std::size_t index, int level = 0)
    {
        return Print(node.children[index], level);
    };
    const int level = LevelOf(node);
    switch (node.kind)
    {
    case Kind::Number:
        return Literal(node);
    case Kind::Name:
        return node.text;
    case Kind::Member:
    case Kind::Swizzle:
        return child(0, 14) + "." + node.text;
    case Kind::Index:
        return child(0, 14) + "[" + child(1) + "]";
    case Kind::Prefix:
    {
        const std::string operand = child(0, level);
        return node.text + (operand[0] == '-' || operand[0] == '+' ? "(" + operand + ")" : operand);
    }
    case Kind::Postfix:
        return child(0, 14) + node.text;
    case Kind::Binary:
        return child(0, level) + " " + node.text + " " + child(1, level + 1);
    case Kind::Ternary:
        return child(0, 3) + " ? " + child(1, 3) + " : " + child(2, 2);
    case Kind::Cast:
        return "(" + node.type.Spelling() + Sizes(node.type) + ")" + child(0, 13);
    case Kind::Construct:
        return Join(node.children, node.type.Spelling() + "(", ")");
    case Kind::List:
        return Join(node.children, "{", "}");
    case Kind::Intrinsic:
    case Kind::Call:
        return Join(node.children, node.text + "(", ")");
    default:
        return child(0, 2) + " " + node.text + " " + child(1, 2);
    }
}

std::string PrintStatement(const Node& node)
{
    const auto child = [&](std::size_t index)
    {
        return Print(node.children[index]);
    };
    switch (node.kind)
    {
    case Kind::Declare:
        return node.type.Spelling() + " " + node.text + Sizes(node.type) + " = " + child(0) + ";\n";
    case Kind::Sentence:
        return child(0) + ";\n";
    case Kind::If:
        return "if (" + child(0) + ")\n" + child(1) +
               (node.children.size() > 2 ? "else\n" + child(2) : "");
    case Kind::For:
        return "for (" + child(0).substr(0, child(0).size() - 1) + " " + child(1) + "; " +
               child(2) + ")\n" + child(3);
    case Kind::While:
        return "while (" + child(0) + ")\n" + child(1);
    case Kind::Do:
        return "do\n" + child(0) + "while (" + child(1) + ");\n";
    case Kind::Break:
        return "break;\n";
    case Kind::Continue:
        return "continue;\n";
    case Kind::Return:
        return node.children.empty() ? "return;\n" : "return " + child(0) + ";\n";
    default:
        break;
    }
    std::string text = node.kind == Kind::Switch ? "switch (" + child(0) + ")\n{\n"
                       : node.kind == Kind::Case ? node.text + ":\n{\n"
                                                 : "{\n";
    for (std::size_t i = node.kind == Kind::Switch ? 1 : 0; i < node.children.size(); ++i)
    {
        text += child(i);
    }
    return text + (node.kind == Kind::Case ? "}\nbreak;\n" : "}\n");
}

std::string Print(const Function& function)
{
    std::string text = function.type.Spelling() + " " + function.name + "(";
    for (const Variable& parameter : function.parameters)
    {
        text += (&parameter == &function.parameters.front() ? "" : ", ") + parameter.mode +
                (parameter.mode.empty() ? "" : " ") + parameter.type.Spelling() + " " +
                parameter.name + Sizes(parameter.type);
    }
    return text + ")\n" + Print(function.body);
}

/// The parts of a variable, each as HLSL.
void AddParts(const std::string& place, const Type& type, std::vector<std::string>& parts)
{
    if (type.isScalar())
    {
        parts.push_back(type.scalar == Scalar::Bool   ? "asuint(" + place + " ? 1.0 : 0.0)"
                        : isFloating(type.scalar)     ? "asuint((float)" + place + ")"
                        : type.scalar == Scalar::Uint ? place
                                                      : "asuint((int)" + place + ")");
        return;
    }
    if (type.record && type.sizes.empty())
    {
        for (const Variable& member : type.record->members)
        {
            AddParts(place + "." + member.name, member.type, parts);
        }
        return;
    }
    const int count = !type.sizes.empty() ? type.sizes[0]
                      : type.rows > 0     ? type.rows
                                          : type.columns;
    for (int i = 0; i < count; ++i)
    {
        AddParts(place + "[" + std::to_string(i) + "]", type.Element(), parts);
    }
}

} // namespace

Type Type::Of(Scalar other) const
{
    Type type = *this;
    type.scalar = other;
    return type;
}

Type Type::As(int newColumns, int newRows) const
{
    return {scalar, newColumns, newRows, {}, nullptr};
}

Type Type::Element() const
{
    if (sizes.empty())
    {
        return As(rows > 0 ? columns : 1);
    }
    Type type = *this;
    type.sizes.erase(type.sizes.begin());
    return type;
}

std::vector<Scalar> Type::Parts() const
{
    std::vector<Scalar> parts;
    if (isNumber())
    {
        parts.resize(static_cast<std::size_t>(columns * std::max(rows, 1)), scalar);
        return parts;
    }
    const auto add = [&](const Type& type)
    {
        const auto more = type.Parts();
        parts.insert(parts.end(), more.begin(), more.end());
    };
    for (int i = 0; !sizes.empty() && i < sizes[0]; ++i)
    {
        add(Element());
    }
    for (std::size_t i = 0; sizes.empty() && record && i < record->members.size(); ++i)
    {
        add(record->members[i].type);
    }
    return parts;
}

std::string Type::Spelling() const
{
    if (record || columns == 0)
    {
        return record ? record->name : "void";
    }
    const std::string name = k_Names[static_cast<std::size_t>(scalar)];
    return rows > 0      ? name + std::to_string(rows) + "x" + std::to_string(columns)
           : columns > 1 ? name + std::to_string(columns)
                         : name;
}

Type Promote(const Type& left, const Type& right)
{
    const Type shape = left.isScalar()    ? right
                       : right.isScalar() ? left
                                          : left.As(std::min(left.columns, right.columns),
                                                    std::min(left.rows, right.rows));
    return shape.Of(std::max(left.scalar, right.scalar));
}

Type BinaryType(const std::string& op, const Type& left, const Type& right)
{
    const Type both = Promote(left, right);
    static const std::string s_Truths = " == != < <= > >= && || ";
    const bool isTruth = s_Truths.find(" " + op + " ") != s_Truths.npos;
    return isTruth                       ? both.Of(Scalar::Bool)
           : both.scalar == Scalar::Bool ? both.Of(Scalar::Int)
                                         : both;
}

Type IntrinsicType(const std::string& name, const std::vector<Node>& arguments)
{
    const Type& first = arguments[0].type;
    Type all = first;
    for (const Node& argument : arguments)
    {
        all = Promote(all, argument.type);
    }
    const Scalar floating = isFloating(all.scalar) ? all.scalar : Scalar::Float;
    if (name == "any" || name == "all")
    {
        return Type{Scalar::Bool};
    }
    if (name == "sign")
    {
        return first.Of(Scalar::Int);
    }
    if (name == "transpose")
    {
        return first.As(first.rows, first.columns);
    }
    if (name == "dot")
    {
        return all.As(1);
    }
    if (name == "mul")
    {
        const Type& last = arguments[1].type;
        const Type shape = first.isMatrix() && last.isMatrix() ? first.As(last.columns, first.rows)
                           : first.isMatrix()                  ? first.As(first.rows)
                                                               : first.As(last.columns);
        return shape.Of(floating);
    }
    const bool isAny = name == "abs" || name == "min" || name == "max" || name == "clamp" ||
                       name == "mad" || name == "countbits" || name == "reversebits";
    return isAny ? all : all.Of(floating);
}

std::string Print(const Node& node, int level)
{
    if (node.kind >= Kind::Declare)
    {
        return PrintStatement(node);
    }
    const std::string text = PrintPlain(node);
    return LevelOf(node) < level ? "(" + text + ")" : text;
}

std::string Print(const Snippet& snippet)
{
    std::string text;
    for (const auto& record : snippet.records)
    {
        text += "struct " + record->name + "\n{\n";
        for (const Variable& member : record->members)
        {
            text += member.type.Spelling() + " " + member.name + Sizes(member.type) + ";\n";
        }
        text += "};\n";
    }
    for (const Node& global : snippet.globals)
    {
        text += (global.number != 0.0 ? "static const " : "static ") + Print(global);
    }
    for (const auto& function : snippet.functions)
    {
        text += Print(*function);
    }
    text += "void " + snippet.name + "(uint thread, uint first)\n{\n" +
            "float4 a = _Floats[thread];\nint4 n = _Integers[thread];\n";
    for (const Node& statement : snippet.body.children)
    {
        text += Print(statement);
    }
    std::vector<std::string> parts;
    for (const Variable& result : snippet.results)
    {
        AddParts(result.name, result.type, parts);
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        text += "_Out[first + " + std::to_string(i) + "] = " + parts[i] + ";\n";
    }
    return text + "}\n";
}

} // namespace limn::test::snippets
