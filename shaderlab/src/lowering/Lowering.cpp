#include "lowering/Lowering.h"

namespace limn
{

namespace
{

bool isTruth(const HlslNode& node)
{
    return node.type.isNumber() && !node.type.isMatrix() && node.type.scalar == HlslScalar::Bool;
}

} // namespace

HlslLowering::HlslLowering(TokenEdits& code, const HlslGlobals& globals)
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
        if (node.kind == HlslNodeKind::Assign)
        {
            LowerTruthAssignment(node);
            LowerIntegerAssignment(node);
            LowerSwizzleAssignment(node);
        }
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
            Cast(*node.child, node.child->type.Of(HlslScalar::Int));
        }
        LowerSwizzleStep(node);
        break;
    case HlslNodeKind::Postfix:
        LowerSwizzleStep(node);
        break;
    case HlslNodeKind::Call:
    case HlslNodeKind::Method:
        LowerCall(node);
        break;
    case HlslNodeKind::Switch:
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
