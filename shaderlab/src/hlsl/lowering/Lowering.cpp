#include "hlsl/lowering/Lowering.h"

namespace limn
{

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

void HlslLowering::LowerNode(HlslNode& node)
{
    switch (node.kind)
    {
    case HlslNodeKind::Cast:
        LowerCast(node);
        break;
    case HlslNodeKind::Construct:
        LowerConstruct(node);
        break;
    case HlslNodeKind::Member:
        LowerSwizzle(node);
        break;
    case HlslNodeKind::Binary:
    case HlslNodeKind::Assign:
        LowerMatrixOperator(node);
        break;
    case HlslNodeKind::Prefix:
        if (Text(node.token) == "-" && node.child->type.isScalar() &&
            node.child->type.scalar == HlslScalar::Bool)
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
    case HlslNodeKind::Declarator:
        LowerDeclarator(node);
        break;
    default:
        break;
    }
}

} // namespace limn
