#include "hlsl/Resolver.h"

#include <limn/base/WordList.h>

#include <algorithm>

namespace limn
{

void HlslResolver::ResolveBody(HlslNode& body, const HlslFunction& function,
                               const HlslStruct* owner)
{
    const auto declare = [this](const HlslVariable& variable)
    {
        Declare(variable.name, {nullptr, &variable, TypeOf(m_Globals.declarations(), variable)});
    };
    Open();
    if (owner)
    {
        std::ranges::for_each(owner->members, declare);
    }
    std::ranges::for_each(function.parameters, declare);
    Resolve(body);
    Close();
}

void HlslResolver::Close()
{
    for (const std::string_view name : m_Scopes.back())
    {
        m_Names[name].pop_back();
    }
    m_Scopes.pop_back();
}

void HlslResolver::Declare(std::string_view name, const Entry& entry)
{
    m_Names[name].push_back(entry);
    m_Scopes.back().push_back(name);
}

void HlslResolver::Resolve(HlslNode& node)
{
    const bool isBlock = node.kind == HlslNodeKind::Block;
    if (isBlock)
    {
        Open();
    }
    for (HlslNode* child = node.child; child; child = child->next)
    {
        Resolve(*child);
    }
    if (isBlock)
    {
        Close();
    }
    ResolveType(node);
}

void HlslResolver::EndLoop(const HlslNode& loop)
{
    for (HlslNode* name = loop.child ? loop.child->child : nullptr; name; name = name->next)
    {
        if (name->kind == HlslNodeKind::Declarator)
        {
            std::vector<Entry>& entries = m_Names[m_Tokens.Text(name->token)];
            std::ranges::find(entries.rbegin(), entries.rend(), name, &Entry::local)->hasEnded =
                true;
        }
    }
}

void HlslResolver::DeclareLocal(HlslNode& declarator)
{
    const std::string_view name = m_Tokens.Text(declarator.token);
    for (std::uint32_t i = declarator.token + 1; i < declarator.end; ++i)
    {
        // Its own value names another one: glslang takes it for the new.
        if (m_Tokens.Text(i) == name && m_Tokens.Text(i - 1) != ".")
        {
            m_Renamed.push_back(&declarator);
            break;
        }
    }
    Declare(name, {&declarator, nullptr, declarator.type});
}

void HlslResolver::ResolveType(HlslNode& node)
{
    const auto first = [&]
    {
        return node.child ? node.child->type : HlslType();
    };
    switch (node.kind)
    {
    case HlslNodeKind::Declarator:
        DeclareLocal(node);
        break;
    case HlslNodeKind::For:
        EndLoop(node);
        break;
    case HlslNodeKind::Name:
        ResolveName(node);
        break;
    case HlslNodeKind::Call:
    case HlslNodeKind::Method:
        node.type = CallType(node);
        break;
    case HlslNodeKind::Member:
        node.type = MemberType(node);
        break;
    case HlslNodeKind::Index:
        node.type = ElementType(first());
        break;
    case HlslNodeKind::Prefix:
        node.type = PrefixType(m_Tokens.Text(node.token), first());
        break;
    case HlslNodeKind::Postfix:
    case HlslNodeKind::Assign:
    case HlslNodeKind::Paren:
        node.type = first();
        break;
    case HlslNodeKind::Binary:
        node.type = BinaryType(node);
        break;
    case HlslNodeKind::Ternary:
        if (node.CountChildren() == 3)
        {
            const HlslType& yes = node.Child(1)->type;
            const HlslType& no = node.Child(2)->type;
            node.type = yes == no ? yes : Promote(yes, no);
        }
        break;
    default:
        break;
    }
}

void HlslResolver::ResolveName(HlslNode& node)
{
    const std::string_view name = m_Tokens.Text(node.token);
    const auto found = m_Names.find(name);
    if (found == m_Names.end() || found->second.empty())
    {
        node.variable = m_Globals.FindVariable(name);
        node.type = node.variable ? TypeOf(m_Globals.declarations(), *node.variable) : HlslType();
        if (!node.variable)
        {
            m_Unknown.push_back({node.token, "unknown variable"});
        }
        return;
    }
    const std::string_view next = m_Tokens.Text(node.token + 1);
    const Entry& meant = Meant(found->second, next == "." || next == "[");
    if (meant.hasEnded && meant.local)
    {
        m_Renamed.push_back(meant.local);
    }
    node.local = meant.local;
    node.variable = meant.variable;
    node.type = meant.type;
}

/// The newest, unless that is the number of a loop that is over, where a number cannot be meant.
const HlslResolver::Entry& HlslResolver::Meant(const std::vector<Entry>& entries, bool hasMembers)
{
    const auto lasting =
        std::ranges::find(entries.rbegin(), entries.rend(), false, &Entry::hasEnded);
    const bool isOther = entries.back().hasEnded && lasting != entries.rend() &&
                         (hasMembers || !lasting->type.isNumber());
    return isOther ? *lasting : entries.back();
}

HlslType HlslResolver::CallType(HlslNode& node)
{
    const std::string_view name = m_Tokens.Text(node.token);
    const bool isMethod = node.kind == HlslNodeKind::Method;
    if (isMethod && node.child->type.kind == HlslType::Kind::Object)
    {
        const HlslType& object = node.child->type;
        const bool isElement = name == "Load" && object.name.find("StructuredBuffer") != name.npos;
        return isElement ? TypeOf(m_Globals.declarations(), object.element, {})
                         : MethodType(object, name);
    }
    std::vector<HlslType> arguments;
    for (const HlslNode* child = node.FirstArgument(); child; child = child->next)
    {
        arguments.push_back(child->type);
    }
    const auto functions = m_Globals.FindCalled(node, name);
    if (functions.empty() && !isMethod)
    {
        if (!isIntrinsic(name))
        {
            m_Unknown.push_back({node.token, "no matching overloaded function found"});
        }
        return IntrinsicType(name, arguments);
    }
    node.isIntrinsic =
        !isMethod && isIntrinsic(name) && TakesNone(m_Globals.declarations(), functions, arguments);
    if (node.isIntrinsic)
    {
        return IntrinsicType(name, arguments);
    }
    node.function = ChooseOverload(m_Globals.declarations(), functions, arguments);
    return node.function ? TypeOf(m_Globals.declarations(), node.function->returnType,
                                  node.function->returnArgument)
                         : HlslType();
}

HlslType HlslResolver::MemberType(const HlslNode& node)
{
    const HlslType& owner = node.child->type;
    const std::string_view name = m_Tokens.Text(node.token);
    if (owner.dimensions > 0 || owner.kind != HlslType::Kind::Struct)
    {
        return SwizzleType(owner, name);
    }
    const HlslStruct* type = m_Globals.declarations().FindStruct(owner.name);
    const auto member = std::ranges::find(type->members, name, &HlslVariable::name);
    if (member == type->members.end())
    {
        m_Unknown.push_back({node.token, "no such field in structure"});
        return {};
    }
    return TypeOf(m_Globals.declarations(), *member);
}

HlslType HlslResolver::PrefixType(std::string_view mark, const HlslType& operand)
{
    const bool isTruth = operand.isNumber() && operand.scalar == HlslScalar::Bool;
    return mark == "!" && operand.isNumber()         ? operand.Of(HlslScalar::Bool)
           : isTruth && (mark == "-" || mark == "~") ? operand.Of(HlslScalar::Int)
                                                     : operand;
}

HlslType HlslResolver::BinaryType(const HlslNode& node) const
{
    static const WordList s_Truths("== != < > <= >= && ||");
    const HlslType& left = node.child->type;
    const HlslType& right = node.child->next ? node.child->next->type : HlslType();
    const std::string_view text = m_Tokens.Text(node.token);
    if (text == ",")
    {
        return right;
    }
    const HlslType both = Promote(left, right);
    if (s_Truths.Has(text))
    {
        return both.isNumber() ? both.Of(HlslScalar::Bool) : HlslType();
    }
    const bool isTruth = both.isNumber() && both.scalar == HlslScalar::Bool;
    return isTruth ? both.Of(HlslScalar::Int) : both;
}

HlslType HlslResolver::ElementType(HlslType type) const
{
    if (type.dimensions > 0)
    {
        --type.dimensions;
        return type;
    }
    if (type.kind == HlslType::Kind::Object)
    {
        const bool isTexture = type.name.find("Texture") != type.name.npos;
        return !type.element.empty() ? TypeOf(m_Globals.declarations(), type.element, {})
               : isTexture           ? HlslType::Number(HlslScalar::Float, 4)
                                     : HlslType();
    }
    return type.isMatrix() ? type.As(type.columns) : type.isVector() ? type.As(1) : HlslType();
}

} // namespace limn
