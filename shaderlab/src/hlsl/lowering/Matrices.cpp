#include "hlsl/lowering/Lowering.h"

#include <algorithm>
#include <vector>

namespace limn
{

namespace
{

/// Calls a function for each float matrix of at least this size.
template <typename F>
void ForEachMatrix(int rows, int columns, F&& each)
{
    for (int row = rows; row <= 4; ++row)
    {
        for (int column = columns; column <= 4; ++column)
        {
            each(HlslType::Number(HlslScalar::Float, column, row).Spelling());
        }
    }
}

/// One overload for each type that the language casts to the matrix.
std::string WriteCast(const HlslType& type, const std::string& function)
{
    const std::string name = type.Spelling();
    const std::string scalar = type.As(1).Spelling();
    std::string elements;
    for (int i = 0; i < type.components(); ++i)
    {
        elements.append(i > 0 ? ", " : "").append(scalar).append("(v)");
    }
    std::string text;
    const auto add = [&](std::string_view parameter, const std::string& value)
    {
        text.append(name).append(" ").append(function).append("(").append(parameter);
        text.append(" v) { return ").append(value).append("; } ");
    };
    for (const std::string_view from : {"float", "int", "uint", "bool"})
    {
        add(from, name + "(" + elements + ")");
    }
    if (type.components() == 4)
    {
        add("float4", name + "(v.x, v.y, v.z, v.w)");
    }
    ForEachMatrix(type.rows, type.columns,
                  [&](const std::string& larger) { add(larger, "(" + name + ")v"); });
    return text;
}

/// "_m03_m13" is {"_m03", "_m13"}; what it is called with is known to name elements.
std::vector<std::string_view> MatrixElements(std::string_view word)
{
    const std::size_t size = word.starts_with("_m") ? 4 : 3;
    std::vector<std::string_view> elements;
    for (; word.size() >= size; word.remove_prefix(size))
    {
        elements.push_back(word.substr(0, size));
    }
    return elements;
}

std::string WriteSwizzle(const HlslType& from, const HlslType& to,
                         const std::vector<std::string_view>& elements, const std::string& function)
{
    std::string values;
    for (const std::string_view element : elements)
    {
        values.append(values.empty() ? "v." : ", v.").append(element);
    }
    return to.Spelling() + " " + function + "(" + from.Spelling() + " v) { return " +
           to.Spelling() + "(" + values + "); } ";
}

/// Whether the node is written to, itself or in part.
bool isTarget(const HlslNode& node)
{
    const HlslNode* child = &node;
    const HlslNode* parent = node.parent;
    while (parent && child == parent->child &&
           (parent->kind == HlslNodeKind::Member || parent->kind == HlslNodeKind::Index))
    {
        child = parent;
        parent = parent->parent;
    }
    return parent && parent->child == child && parent->kind == HlslNodeKind::Assign;
}

} // namespace

std::string HlslLowering::CastFunction(const HlslType& type)
{
    const std::string function = "limn_" + type.Spelling();
    Need(WriteCast(type, function));
    return function;
}

/// Of an integer cast to a matrix glslang takes the bits for floats.
void HlslLowering::LowerCast(HlslNode& node, bool isInitial)
{
    if (!node.type.isMatrix() || !node.child ||
        (node.child->type.isMatrix() && node.child->type.isFloating()))
    {
        return;
    }
    const std::size_t operand = node.child->first;
    if (!isInitial)
    {
        m_Code.Erase(node.first, operand);
        // The preprocessor leaves no blank between `return` and a bracket.
        m_Code.Spelling(node.first) = " ";
        Wrap(*node.child, CastFunction(node.type) + "(", ")");
    }
    else if (node.type.isFloating())
    {
        Wrap(*node.child, "(1.0 * (", "))");
    }
}

/// A cast as a constructor: with several values it is one as glslang knows it.
void HlslLowering::LowerConstruct(HlslNode& node, bool isInitial)
{
    if (!node.type.isMatrix() || node.CountChildren() != 1)
    {
        return;
    }
    if (!isInitial)
    {
        const std::size_t open = m_Code.FindOutside(node.first, "(");
        m_Code.Erase(node.first, open);
        m_Code.Spelling(node.first) = CastFunction(node.type);
    }
    else if (node.type.isFloating())
    {
        Wrap(*node.child, "1.0 * (", ")");
    }
}

/// What glslang makes of several elements of a matrix is not valid SPIR-V.
void HlslLowering::LowerSwizzle(HlslNode& node, bool isInitial)
{
    const HlslType& matrix = node.child->type;
    if (!matrix.isMatrix() || node.type.isScalar() || !node.type.isNumber() || isTarget(node))
    {
        return;
    }
    const std::string_view letters = Text(node.token);
    const std::vector<std::string_view> elements = MatrixElements(letters);
    const std::size_t dot = node.token - 1;
    if (!isInitial)
    {
        const std::string function = "limn" + std::string(letters);
        Need(WriteSwizzle(matrix, node.type, elements, function));
        m_Code.Erase(dot, node.end);
        Wrap(*node.child, " " + function + "(", ")");
        return;
    }
    const std::string operand(m_Code.Span(node.first, dot));
    std::string values;
    for (const std::string_view element : elements)
    {
        values.append(values.empty() ? "" : ", ").append(operand).append(".").append(element);
    }
    m_Code.Erase(node.first, node.end);
    m_Code.Spelling(node.first) = node.type.Spelling() + "(" + values + ")";
}

/// Of matrices of two sizes both count as far as the smaller goes.
void HlslLowering::LowerMatrixOperator(HlslNode& node)
{
    if (!node.child->next || Text(node.token) == ",")
    {
        return;
    }
    const HlslType& left = node.child->type;
    const HlslType& right = node.child->next->type;
    if (!left.isMatrix() || !right.isMatrix())
    {
        return;
    }
    const int rows = std::min(left.rows, right.rows);
    const int columns = std::min(left.columns, right.columns);
    for (HlslNode* operand : {node.child, node.child->next})
    {
        if (operand->type.rows != rows || operand->type.columns != columns)
        {
            Wrap(*operand, "(" + operand->type.As(columns, rows).Spelling() + ")(", ")");
        }
    }
}

/// What works on each element of a matrix has no SPIR-V: it is called for each row.
void HlslLowering::LowerMatrixFunction(HlslNode& node)
{
    const std::string_view name = Text(node.token);
    if (!node.type.isMatrix() || !isComponentwise(name))
    {
        return;
    }
    const std::string type = node.type.Spelling();
    std::string parameters;
    std::string rows;
    int count = 0;
    for (const HlslNode* argument = node.child; argument; argument = argument->next, ++count)
    {
        const std::string separator = count > 0 ? ", " : "";
        const bool isWhole = argument->type.isScalar();
        parameters += separator + (isWhole ? node.type.As(1).Spelling() : type) + " v" +
                      std::to_string(count);
    }
    for (int row = 0; row < node.type.rows; ++row)
    {
        rows += std::string(row > 0 ? ", " : "") + std::string(name) + "(";
        int index = 0;
        for (const HlslNode* argument = node.child; argument; argument = argument->next, ++index)
        {
            rows += (index > 0 ? ", v" : "v") + std::to_string(index);
            rows += argument->type.isScalar() ? "" : "[" + std::to_string(row) + "]";
        }
        rows += ")";
    }
    const std::string function = "limn_" + std::string(name);
    Need(type + " " + function + "(" + parameters + ") { return " + type + "(" + rows + "); } ");
    m_Code.Spelling(node.token) = function;
}

} // namespace limn
