#include "hlsl/lowering/Lowering.h"

namespace limn
{

namespace
{

bool isTruth(const HlslNode& node)
{
    return node.type.isScalar() && node.type.scalar == HlslScalar::Bool;
}

} // namespace

HlslLowering::HlslLowering(HlslEditor& code, const HlslGlobals& globals)
    : m_Code(code), m_Globals(globals)
{
}

void HlslLowering::Wrap(const HlslNode& node, std::string_view before, std::string_view after)
{
    m_Code.Wrap(node.first, node.end, before, after);
}

void HlslLowering::Need(const std::string& text)
{
    if (m_Known.insert(text).second)
    {
        m_Functions += text;
    }
}

void HlslLowering::Lower(HlslNode& node, bool isInitial)
{
    const bool isStatic = node.kind == HlslNodeKind::Declaration &&
                          m_Code.Span(node.first, node.token).starts_with("static");
    for (HlslNode* child = node.child; child; child = child->next)
    {
        Lower(*child, isInitial || isStatic);
    }
    m_IsInitial = isInitial || isStatic;
    LowerNode(node);
}

/// glslang makes invalid SPIR-V of `a &= b` where they are true or false, not of `a = a & b`.
void HlslLowering::LowerTruthAssignment(const HlslNode& node)
{
    const std::string_view mark = Text(node.token);
    if ((mark == "&=" || mark == "|=" || mark == "^=") &&
        node.child->type.scalar == HlslScalar::Bool && node.child->type.isNumber())
    {
        const std::string target = m_Code.Spelled(node.child->first, node.child->end);
        m_Code.Spelling(node.token) = "= " + target + " " + std::string(mark.substr(0, 1)) + " (" +
                                      node.child->type.Spelling() + ")(";
        Wrap(*node.child->next, "", ")");
    }
}

void HlslLowering::LowerNode(HlslNode& node)
{
    switch (node.kind)
    {
    case HlslNodeKind::Cast:
        LowerConstantCast(node);
        LowerCast(node);
        break;
    case HlslNodeKind::Construct:
        LowerConstantCast(node);
        LowerConstruct(node);
        break;
    case HlslNodeKind::Member:
        LowerSwizzle(node);
        break;
    case HlslNodeKind::Binary:
    case HlslNodeKind::Assign:
        LowerTruthAssignment(node);
        LowerSwizzleAssignment(node);
        if (Text(node.token) == "=")
        {
            LowerConstantCast(node);
        }
        LowerMatrixOperator(node);
        LowerFolding(node);
        break;
    case HlslNodeKind::Prefix:
        if ((Text(node.token) == "-" || Text(node.token) == "~") && isTruth(*node.child))
        {
            Wrap(*node.child, "(int)(", ")");
        }
        break;
    case HlslNodeKind::Call:
    case HlslNodeKind::Method:
        LowerCall(node);
        break;
    case HlslNodeKind::Switch:
        if (node.child && node.child->type.isFloating())
        {
            Wrap(*node.child, "(int)(", ")");
        }
        break;
    case HlslNodeKind::Label:
        if (node.child && node.child->type.isFloating())
        {
            Wrap(*node.child, "(int)(", ")");
        }
        break;
    case HlslNodeKind::Declarator:
        LowerConstantCast(node);
        LowerDeclarator(node);
        break;
    default:
        break;
    }
}

} // namespace limn
