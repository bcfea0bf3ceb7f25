#include "lowering/Lowering.h"

#include <charconv>
#include <cmath>
#include <optional>

// glslang computes some operations in its own way while it compiles; those that it leaves to the
// device are corrected in its SPIR-V (see spirv/Arithmetic.h).

namespace limn
{

namespace
{

/// Returns whether the compiler may know the value: it names nothing that changes and calls no
/// function of the author.
bool MayBeConstant(const HlslNode& node, const TokenEdits& code)
{
    switch (node.kind)
    {
    case HlslNodeKind::Name:
        return node.variable
                   ? node.variable->Has("const")
                   : node.local && node.local->parent->kind == HlslNodeKind::Declaration &&
                         code.Span(node.local->parent->first, node.local->token).find("const") !=
                             std::string_view::npos;
    case HlslNodeKind::Unknown:
    case HlslNodeKind::Method:
    case HlslNodeKind::Assign:
    case HlslNodeKind::Postfix:
        return false;
    default:
        break;
    }
    bool isConstant = !node.function;
    for (const HlslNode* child = node.child; child && isConstant; child = child->next)
    {
        isConstant = MayBeConstant(*child, code);
    }
    return isConstant;
}

std::optional<double> NumberOf(std::string_view literal)
{
    double value = 0.0;
    const char* const end = literal.data() + literal.size();
    const auto [rest, error] = std::from_chars(literal.data(), end, value);
    const bool isWhole = error == std::errc() && end - rest <= 1; // 1.5f
    return isWhole ? std::optional(value) : std::nullopt;
}

/// The value of a number that is written with operators only; nothing of others.
///
/// @param names  how many variables may stand for one another
std::optional<double> ValueOf(const HlslNode& node, const TokenEdits& code, int names = 4)
{
    const std::string_view text = code.Text(node.token);
    const auto first = [&]
    {
        return ValueOf(*node.child, code, names);
    };
    switch (node.kind)
    {
    case HlslNodeKind::Literal:
        return NumberOf(text);
    case HlslNodeKind::Paren:
        return first();
    case HlslNodeKind::Name:
        return names > 0 && node.local && node.local->child
                   ? ValueOf(*node.local->child, code, names - 1)
                   : std::nullopt;
    case HlslNodeKind::Prefix:
        if (const auto value = first(); value && text == "-")
        {
            return -*value;
        }
        return std::nullopt;
    case HlslNodeKind::Binary:
    {
        const auto left = first();
        const auto right = ValueOf(*node.last, code, names);
        const bool isKnown = left && right && node.type.isFloating();
        return !isKnown      ? std::nullopt
               : text == "+" ? std::optional(*left + *right)
               : text == "-" ? std::optional(*left - *right)
               : text == "*" ? std::optional(*left * *right)
               : text == "/" ? std::optional(*left / *right)
                             : std::nullopt;
    }
    default:
        return std::nullopt;
    }
}

bool HoldsValue(const HlslType& integer, double value)
{
    const bool isSigned = integer.scalar == HlslScalar::Int;
    const double whole = std::trunc(value);
    return whole >= (isSigned ? -0x1p31 : 0.0) && whole < (isSigned ? 0x1p31 : 0x1p32);
}

} // namespace

/// Keeps a value from being computed with while the program is compiled.
void HlslLowering::Hide(const HlslNode& node)
{
    const std::string type = node.type.Spelling();
    Need(type + " limn_runtime(" + type + " v) { return v; } ");
    Wrap(node, "limn_runtime(", ")");
}

/// Returns whether glslang gets the operation wrong if all its operands are constant.
bool HlslLowering::FoldsWrong(const HlslNode& node) const
{
    const std::string_view name = Text(node.token);
    const std::size_t count = node.CountChildren();
    const auto isNumber = [&](const HlslNode& operand)
    {
        return !std::isnan(ValueOf(operand, m_Code).value_or(NAN));
    };
    if (name == "round")
    {
        return count == 1 && node.type.isFloating();
    }
    if (count != 2 || !node.child->type.isNumber() || !node.last->type.isNumber())
    {
        return false;
    }
    const HlslType type = Promote(node.child->type, node.last->type);
    if (name == "fmod" || name == "%")
    {
        const double divisor = ValueOf(*node.last, m_Code).value_or(type.isVector() ? 0.0 : 1.0);
        return node.type.isFloating() || (type.scalar == HlslScalar::Uint && divisor == 0.0);
    }
    const bool isOfNumbers = isNumber(*node.child) && isNumber(*node.last);
    if (name == "min" || name == "max" || name == "step")
    {
        return node.type.isFloating() && !isOfNumbers;
    }
    if (name == "dot")
    {
        return !node.type.isFloating();
    }
    const bool isOrder = name == "<" || name == "<=" || name == ">" || name == ">=";
    return isOrder && (type.isVector() || (type.isFloating() && !isOfNumbers));
}

/// `dot` of integers as a sum.
void HlslLowering::SpellDot(const HlslNode& node)
{
    const std::string x = "(" + m_Code.Spelled(node.child->first, node.child->end) + ")";
    const std::string y = "(" + m_Code.Spelled(node.last->first, node.last->end) + ")";
    const auto part = [](const HlslNode& operand, int index)
    {
        return operand.type.isScalar() ? "" : std::string(".") + "xyzw"[index];
    };
    std::string sum;
    const int count = Promote(node.child->type, node.last->type).columns;
    for (int i = 0; i < count; ++i)
    {
        sum += (i > 0 ? " + " : "") + x + part(*node.child, i) + " * " + y + part(*node.last, i);
    }
    m_Code.Erase(node.first, node.end);
    m_Code.Spelling(node.first) = "(" + sum + ")";
}

/// Returns whether a static variable gets the right value only if a function computes it: elements
/// of matrices, and comparisons of vectors.
bool HlslLowering::NeedsFunction(const HlslNode& value) const
{
    const auto isOne = [&](const HlslNode& part)
    {
        const std::string_view text = Text(part.token);
        const bool isOfMatrices = part.kind == HlslNodeKind::Binary &&
                                  part.child->type.isMatrix() &&
                                  (text == "%" || (text == "*" && part.last->type.isMatrix()));
        const bool isOrder = part.kind == HlslNodeKind::Binary && part.type.isVector() &&
                             part.type.scalar == HlslScalar::Bool && text != "&&" && text != "||";
        return isOfMatrices || isOrder ||
               (part.kind == HlslNodeKind::Call && part.type.isMatrix() && isComponentwise(text));
    };
    return FindNode(value, isOne) != nullptr;
}

/// Keeps glslang from computing operations that it gets wrong while it compiles: remainders,
/// `round`, comparisons of vectors, and tests of NaN.
void HlslLowering::LowerFolding(HlslNode& node)
{
    if ((node.type.isMatrix() && m_IsInitial) || !FoldsWrong(node) || !MayBeConstant(node, m_Code))
    {
        return;
    }
    if (!m_IsInitial)
    {
        Hide(*node.child);
        return;
    }
    const std::string_view name = Text(node.token);
    if (name == "dot")
    {
        SpellDot(node);
        return;
    }
    const bool isRemainder = name == "fmod" || name == "%";
    if (!node.type.isFloating() || (!isRemainder && name != "round"))
    {
        return;
    }
    const std::string x = "(1.0 * (" + m_Code.Spelled(node.child->first, node.child->end) + "))";
    const std::string y = "(" + m_Code.Spelled(node.last->first, node.last->end) + ")";
    m_Code.Erase(node.first, node.end);
    // If two whole numbers are equally near, the upper one is taken if it is even.
    m_Code.Spelling(node.first) = isRemainder
                                      ? "(" + x + " - " + y + " * trunc(" + x + " / " + y + "))"
                                      : "(floor(" + x + " + 0.5) - (1.0 - ceil(frac(" + x +
                                            " + 0.5))) * 2.0 * frac(floor(" + x + " + 0.5) * 0.5))";
}

/// A constant that becomes an integer which cannot hold it: cast, declared with it or assigned.
void HlslLowering::LowerConstantCast(const HlslNode& node)
{
    const bool isInteger =
        node.type.scalar == HlslScalar::Int || node.type.scalar == HlslScalar::Uint;
    if (m_IsInitial || !isInteger || node.type.isMatrix() || node.type.dimensions > 0)
    {
        return;
    }
    for (const HlslNode* part = node.child; part; part = part->next)
    {
        const bool isVaried = !part->type.isFloating() || part->type.isMatrix();
        if (isVaried || !MayBeConstant(*part, m_Code))
        {
            continue;
        }
        const auto value = ValueOf(*part, m_Code);
        if (!value || !HoldsValue(node.type, *value))
        {
            Hide(*part);
        }
    }
}

} // namespace limn
