#include "lowering/Lowering.h"

#include <limn/base/WordList.h>

#include <algorithm>

namespace limn
{

namespace
{

/// Returns whether the place of an expression requires that its whole numbers are integers. With
/// floats of the same values, a division, a bit operation or a count would give another result, or
/// none.
bool MattersAsInteger(const HlslNode& node)
{
    const HlslNode* const parent = node.parent;
    const auto isInteger = [](const HlslNode& other)
    {
        return other.type.isNumber() && !other.type.isFloating();
    };
    switch (parent ? parent->kind : HlslNodeKind::Unknown)
    {
    case HlslNodeKind::Paren:
    case HlslNodeKind::Member:
        return MattersAsInteger(*parent);
    case HlslNodeKind::Prefix:
    case HlslNodeKind::Switch:
    case HlslNodeKind::Method:
    case HlslNodeKind::Return:
        return true;
    case HlslNodeKind::Index:
        return parent->child != &node || MattersAsInteger(*parent);
    case HlslNodeKind::Assign: // the integer may be one without a sign
        return isInteger(*parent->child);
    case HlslNodeKind::Binary:
    case HlslNodeKind::Ternary:
    case HlslNodeKind::Declarator:
    case HlslNodeKind::Cast:
    case HlslNodeKind::Construct:
        return isInteger(*parent);
    case HlslNodeKind::Call:
        return parent->function || isInteger(*parent);
    default:
        return false;
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
    for (int row = type.rows; row <= 4; ++row)
    {
        for (int column = type.columns; column <= 4; ++column)
        {
            add(HlslType::Number(HlslScalar::Float, column, row).Spelling(), "(" + name + ")v");
        }
    }
    return text;
}

} // namespace

void HlslLowering::LowerCall(HlslNode& node)
{
    const std::string_view name = Text(node.token);
    const bool isMethod = node.kind == HlslNodeKind::Method;
    if (const HlslFunction* function = node.function)
    {
        if (const std::string* spelling = m_Globals.FindSpelling(*function))
        {
            m_Code.Spelling(node.token) = *spelling;
        }
        std::size_t index = 0;
        for (HlslNode* argument = node.FirstArgument(); argument; argument = argument->next)
        {
            LowerArgument(*argument, function->parameters[index++]);
        }
        if (!isMethod)
        {
            LowerOutputs(node);
        }
    }
    else if (isMethod)
    {
        LowerGather(node);
    }
    else if (node.isIntrinsic || m_Globals.FindCalled(node, name).empty())
    {
        LowerHidden(node);
        if ((name == "any" || name == "all") && node.child)
        {
            LowerTruth(node);
        }
        LowerFloats(node);
        LowerSingle(node);
        LowerParts(node);
        LowerExponent(node);
        LowerInteger(node);
        LowerSign(node);
        LowerLit(node);
        LowerMatrixFunction(node);
        LowerFolding(node);
    }
}

/// A function of the language that the author has another of: to glslang the author's hides all, so
/// that it is called from where that is not declared yet.
void HlslLowering::LowerHidden(const HlslNode& node)
{
    if (!node.isIntrinsic || !node.type.isNumber() || m_IsInitial)
    {
        return;
    }
    const std::string name(Text(node.token));
    std::string parameters;
    std::string arguments;
    for (const HlslNode* argument = node.child; argument; argument = argument->next)
    {
        const bool isNumber = argument->type.isNumber();
        if (!isNumber && argument->type.kind != HlslType::Kind::Object)
        {
            return;
        }
        const std::string comma = arguments.empty() ? "" : ", ";
        const std::string own = "v" + std::to_string(parameters.size());
        parameters += comma +
                      (isNumber ? argument->type.Spelling() : std::string(argument->type.name)) +
                      " " + own;
        arguments += comma + own;
    }
    Need(node.type.Spelling() + " limn_" + name + "_(" + parameters + ") { return " + name + "(" +
         arguments + "); } ");
    m_Code.Spelling(node.token) = "limn_" + name + "_";
}

/// Without an offset glslang makes invalid SPIR-V of it.
void HlslLowering::LowerGather(const HlslNode& node)
{
    constexpr std::size_t k_WithoutOffset = 4; // texture, sampler, place and what is compared
    if (Text(node.token).starts_with("GatherCmp") && node.CountChildren() == k_WithoutOffset)
    {
        Wrap(*node.last, "", ", int2(0, 0)");
    }
}

/// Makes `any` and `all` of numbers, and of a single value, ask whether they are not 0.
void HlslLowering::LowerTruth(HlslNode& node)
{
    const HlslType& given = node.child->type;
    if (given.isScalar())
    {
        m_Code.Spelling(node.token) = "(bool)";
    }
    else if (given.isVector() && given.scalar != HlslScalar::Bool)
    {
        Cast(*node.child, given.Of(HlslScalar::Bool));
    }
}

/// `frexp` and `modf` give a part back by a parameter; where that is an integer, glslang crashes.
void HlslLowering::LowerParts(HlslNode& node)
{
    const std::string name(Text(node.token));
    if ((name != "frexp" && name != "modf") || node.CountChildren() != 2)
    {
        return;
    }
    const HlslType& part = node.child->next->type;
    if (part.isNumber() && !part.isMatrix() && !part.isFloating())
    {
        const std::string type = part.Of(HlslScalar::Float).Spelling();
        Need(type + " limn_" + name + "(" + type + " x, out " + part.Spelling() + " part) { " +
             type + " p; " + type + " rest = " + name + "(x, p); part = (" + part.Spelling() +
             ")p; return rest; } ");
        m_Code.Spelling(node.token) = "limn_" + name;
    }
}

/// A function of floats takes what is true or false, and integers, as well. Of some that say so
/// glslang does not know how many numbers they are, and makes 0 of `sqrt(dot(n, n))`, a function of
/// one argument that is the integer which another function gives.
void HlslLowering::LowerFloats(HlslNode& node)
{
    const std::string_view name = Text(node.token);
    const bool readsBits = name == "asfloat" || name == "f16tof32";
    const bool takesOne = node.CountChildren() == 1;
    for (HlslNode* argument = node.child; node.type.isFloating() && !readsBits && argument;
         argument = argument->next)
    {
        const HlslType& given = argument->type;
        const bool isTaken = given.isFloating() || (!takesOne && given.scalar != HlslScalar::Bool);
        if (given.isNumber() && !given.isMatrix() && !isTaken)
        {
            Cast(*argument, given.Of(HlslScalar::Float));
        }
    }
}

/// Functions of vectors take a single value as a vector of one; glslang does not know how long it
/// is.
void HlslLowering::LowerSingle(HlslNode& node)
{
    static const WordList s_OfVectors("normalize reflect refract faceforward");
    const std::string_view name = Text(node.token);
    if (!s_OfVectors.Has(name) || !node.child || !node.type.isScalar())
    {
        return;
    }
    const std::string type = HlslType::Number(node.type.scalar, 2).Spelling();
    for (HlslNode* argument = node.child; argument; argument = argument->next)
    {
        const bool isRatio = name == "refract" && argument == node.last;
        if (!isRatio)
        {
            Wrap(*argument, type + "(", ", 0)");
        }
    }
    Wrap(node, "", ".x");
}

/// `ldexp(x, e)` takes any number as the exponent; glslang makes invalid SPIR-V of floats.
void HlslLowering::LowerExponent(HlslNode& node)
{
    if (Text(node.token) != "ldexp" || node.CountChildren() != 2 || !node.type.isNumber())
    {
        return;
    }
    const std::string type = node.type.Of(HlslScalar::Float).Spelling();
    Need(type + " limn_ldexp(" + type + " x, " + type + " e) { return x * exp2(e); } ");
    m_Code.Spelling(node.token) = "limn_ldexp";
}

/// Lowers functions of integers: glslang makes invalid SPIR-V of `mad`, and treats the `abs` and
/// the `dot` of uints as those of ints.
void HlslLowering::LowerInteger(HlslNode& node)
{
    const std::string_view name = Text(node.token);
    if (!node.type.isNumber() || node.type.isMatrix() || node.type.isFloating())
    {
        return;
    }
    const std::string type = node.type.Spelling();
    if (name == "mad" && m_IsInitial)
    {
        m_Code.Erase(node.token, node.token + 1);
        Wrap(*node.child, "(", ")");
        Wrap(*node.child->next, "(", ")");
        Wrap(*node.last, "(", ")");
        m_Code.Spelling(node.child->end) = " * ";
        m_Code.Spelling(node.child->next->end) = " + ";
    }
    else if (name == "mad")
    {
        Need(type + " limn_mad(" + type + " x, " + type + " y, " + type +
             " z) { return x * y + z; } ");
        m_Code.Spelling(node.token) = "limn_mad";
    }
    else if (name == "dot" && node.type.scalar == HlslScalar::Uint)
    {
        Wrap(node, "((uint)", ")");
    }
    else if (name == "abs" && node.type.scalar == HlslScalar::Uint)
    {
        m_Code.Spelling(node.token) = "(" + type + ")";
    }
}

/// `sign` gives integers; to glslang those of floats are floats, and numbers without a sign have
/// one.
void HlslLowering::LowerSign(const HlslNode& node)
{
    const HlslType given = node.child ? node.child->type : HlslType();
    if (Text(node.token) != "sign" || !given.isNumber() || given.isMatrix())
    {
        return;
    }
    if (given.scalar == HlslScalar::Uint)
    {
        m_Code.Spelling(node.token) = "(" + node.type.Spelling() + ")min";
        Wrap(*node.child, "", ", (" + given.Spelling() + ")1");
    }
    else if (given.isFloating() && MattersAsInteger(node))
    {
        Wrap(node, "((" + node.type.Spelling() + ")", ")");
    }
}

/// glslang multiplies by the exponent.
void HlslLowering::LowerLit(HlslNode& node)
{
    if (Text(node.token) == "lit" && node.CountChildren() == 3)
    {
        Need("float4 limn_lit(float light, float middle, float power) { return float4(1.0, "
             "max(light, 0.0), light < 0.0 || middle < 0.0 ? 0.0 : pow(middle, power), 1.0); } ");
        m_Code.Spelling(node.token) = "limn_lit";
    }
}

/// The language cuts what is larger than the parameter; glslang only from vector to vector.
void HlslLowering::LowerArgument(HlslNode& argument, const HlslVariable& parameter)
{
    const HlslType wanted = TypeOf(m_Globals.declarations(), parameter);
    const HlslType& given = argument.type;
    if (!wanted.isNumber() || !given.isNumber() || parameter.isOutput())
    {
        return;
    }
    const bool isCut = wanted.isScalar() && !given.isScalar();
    const bool isOther = wanted.isMatrix() && given.isMatrix() &&
                         (wanted.rows != given.rows || wanted.columns != given.columns);
    if (isCut || (isOther && given.isFloating()))
    {
        Cast(argument, wanted);
    }
    else if (!m_IsInitial && (isOther || (wanted.isMatrix() && given.isScalar())))
    {
        Wrap(argument, CastFunction(wanted) + "(", ")");
    }
}

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
    const std::size_t dot = node.token - 1;
    if (!m_IsInitial)
    {
        m_Code.Erase(dot, node.end);
        Wrap(*node.child, " " + SwizzleFunction(node) + "(", ")");
        return;
    }
    const std::string operand(m_Code.Span(node.first, dot));
    m_Code.Erase(node.first, node.end);
    m_Code.Spelling(node.first) = ReadElements(node.type, operand, Text(node.token));
}

/// Gives elements of a matrix.
std::string HlslLowering::SwizzleFunction(const HlslNode& node)
{
    const std::string_view letters = Text(node.token);
    const std::string function = "limn" + std::string(letters);
    Need(node.type.Spelling() + " " + function + "(" + node.child->type.Spelling() +
         " v) { return " + ReadElements(node.type, "v", letters) + "; } ");
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
