#include "lowering/Lowering.h"

#include <limn/base/WordList.h>

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
    if (Text(node.token) == "sign" && given.isNumber() && !given.isMatrix() &&
        given.scalar == HlslScalar::Uint)
    {
        m_Code.Spelling(node.token) = "(" + node.type.Spelling() + ")min";
        Wrap(*node.child, "", ", (" + given.Spelling() + ")1");
    }
    const bool isOfFloats = node.child && node.child->type.isFloating();
    if (Text(node.token) == "sign" && isOfFloats && !node.type.isMatrix() && MattersAsInteger(node))
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

} // namespace limn
