#include "lowering/Lowering.h"

#include <algorithm>

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

/// "v._m03, v._m13" of "_m03_m13", which is known to name elements.
std::string ElementsOf(const std::string& operand, std::string_view word)
{
    const std::size_t size = word.starts_with("_m") ? 4 : 3;
    std::string elements;
    for (; word.size() >= size; word.remove_prefix(size))
    {
        elements.append(elements.empty() ? "" : ", ").append(operand).append(".");
        elements.append(word.substr(0, size));
    }
    return elements;
}

} // namespace

std::string HlslLowering::CastFunction(const HlslType& type)
{
    const std::string function = "limn_" + type.Spelling();
    Need(WriteCast(type, function));
    return function;
}

/// Lowers a cast of an integer to a matrix, whose bits glslang takes for floats.
void HlslLowering::LowerCast(HlslNode& node)
{
    if (node.type.dimensions > 0)
    {
        LowerArrayCast(node);
        return;
    }
    if (!node.type.isMatrix() || !node.child ||
        (node.child->type.isMatrix() && node.child->type.isFloating()))
    {
        return;
    }
    const std::size_t operand = node.child->first;
    if (!m_IsInitial)
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
void HlslLowering::LowerConstruct(HlslNode& node)
{
    if (!node.type.isMatrix() || node.CountChildren() != 1)
    {
        return;
    }
    if (!m_IsInitial)
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

/// Lowers the access to several elements of a matrix, of which glslang makes invalid SPIR-V.
void HlslLowering::LowerSwizzle(HlslNode& node)
{
    const HlslType& matrix = node.child->type;
    if (!matrix.isMatrix() || node.type.isScalar() || !node.type.isNumber() || isTarget(node))
    {
        return;
    }
    const std::string_view letters = Text(node.token);
    const std::string type = node.type.Spelling();
    const std::size_t dot = node.token - 1;
    if (!m_IsInitial)
    {
        m_Code.Erase(dot, node.end);
        Wrap(*node.child, " " + SwizzleFunction(node) + "(", ")");
        return;
    }
    const std::string operand(m_Code.Span(node.first, dot));
    m_Code.Erase(node.first, node.end);
    m_Code.Spelling(node.first) = type + "(" + ElementsOf(operand, letters) + ")";
}

/// Gives elements of a matrix.
std::string HlslLowering::SwizzleFunction(const HlslNode& node)
{
    const std::string_view letters = Text(node.token);
    const std::string type = node.type.Spelling();
    const std::string function = "limn" + std::string(letters);
    Need(type + " " + function + "(" + node.child->type.Spelling() + " v) { return " + type + "(" +
         ElementsOf("v", letters) + "); } ");
    return function;
}

/// Lowers an operator of two matrices. If their sizes differ, each counts as far as the smaller one
/// goes. `*` multiplies element by element; for glslang it is the product of matrices.
void HlslLowering::LowerMatrixOperator(HlslNode& node)
{
    HlslNode* const left = node.child;
    HlslNode* const right = left->next;
    const std::string_view text = Text(node.token);
    if (!right || !left->type.isMatrix() || !right->type.isMatrix() || text == ",")
    {
        return;
    }
    const bool isAssignment = node.kind == HlslNodeKind::Assign;
    const HlslType type = isAssignment
                              ? left->type
                              : left->type.As(std::min(left->type.columns, right->type.columns),
                                              std::min(left->type.rows, right->type.rows));
    for (HlslNode* operand : {left, right})
    {
        if (operand->type.rows != type.rows || operand->type.columns != type.columns)
        {
            Cast(*operand, type.Of(operand->type.scalar));
        }
    }
    if (m_IsInitial || (text != "*" && text != "*="))
    {
        return;
    }
    const std::string function = MultiplyFunction(type.Of(HlslScalar::Float), isAssignment);
    m_Code.Spelling(node.token) = ",";
    Wrap(node, function + "(", ")");
}

/// @param isAssignment  whether the product becomes the first factor's value
std::string HlslLowering::MultiplyFunction(const HlslType& type, bool isAssignment)
{
    std::string rows;
    for (int row = 0; row < type.rows; ++row)
    {
        const std::string index = "[" + std::to_string(row) + "]";
        rows += (row > 0 ? ", a" : "a") + index + " * b" + index;
    }
    const std::string name = type.Spelling();
    const std::string function = isAssignment ? "limn_multiply_by" : "limn_multiply";
    Need(name + " " + function + (isAssignment ? "(inout " : "(") + name + " a, " + name +
         " b) { " + (isAssignment ? "a = " : "return ") + name + "(" + rows + "); " +
         (isAssignment ? "return a; } " : "} "));
    return function;
}

/// Calls a function of each element once for each row of a matrix, because SPIR-V has none for
/// matrices.
void HlslLowering::LowerMatrixFunction(HlslNode& node)
{
    const std::string_view name = Text(node.token);
    if (m_IsInitial || !node.type.isMatrix() || !isComponentwise(name))
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
