#include "hlsl/Resolver.h"

#include <algorithm>
#include <array>

namespace limn
{

HlslResolver::HlslResolver(const HlslTokens& tokens, const HlslGlobals& globals)
    : m_Tokens(tokens), m_Globals(globals)
{
}

void HlslResolver::ResolveBody(HlslNode& body, const HlslFunction& function,
                               const HlslStruct* owner)
{
    Open();
    if (owner)
    {
        for (const HlslVariable& member : owner->members)
        {
            Declare(member.name, {nullptr, &member, TypeOf(m_Globals.declarations(), member)});
        }
    }
    for (const HlslVariable& parameter : function.parameters)
    {
        Declare(parameter.name, {nullptr, &parameter, TypeOf(m_Globals.declarations(), parameter)});
    }
    ResolveStatement(body);
    Close();
}

void HlslResolver::ResolveValue(HlslNode& value)
{
    Open();
    ResolveExpression(value);
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

void HlslResolver::ResolveStatement(HlslNode& node)
{
    switch (node.kind)
    {
    case HlslNodeKind::Block:
        Open();
        for (HlslNode* child = node.child; child; child = child->next)
        {
            ResolveStatement(*child);
        }
        Close();
        break;
    case HlslNodeKind::Declaration:
        ResolveDeclaration(node);
        break;
    case HlslNodeKind::For:
        ResolveFor(node);
        break;
    case HlslNodeKind::If:
    case HlslNodeKind::While:
    case HlslNodeKind::Do:
    case HlslNodeKind::Switch:
    case HlslNodeKind::Label:
    case HlslNodeKind::Return:
    case HlslNodeKind::Expression:
        for (HlslNode* child = node.child; child; child = child->next)
        {
            ResolveStatement(*child);
        }
        break;
    default:
        ResolveExpression(node);
        break;
    }
}

void HlslResolver::ResolveFor(HlslNode& node)
{
    for (HlslNode* child = node.child; child; child = child->next)
    {
        ResolveStatement(*child);
    }
    if (!node.child || node.child->kind != HlslNodeKind::Declaration)
    {
        return;
    }
    for (HlslNode* name = node.child->child; name; name = name->next)
    {
        if (name->kind == HlslNodeKind::Declarator)
        {
            std::vector<Entry>& entries = m_Names[m_Tokens.Text(name->token)];
            const auto own = std::find_if(entries.rbegin(), entries.rend(),
                                          [&](const Entry& entry) { return entry.local == name; });
            own->hasEnded = true;
        }
    }
}

void HlslResolver::ResolveDeclaration(HlslNode& node)
{
    for (HlslNode* child = node.child; child; child = child->next)
    {
        if (child->kind != HlslNodeKind::Declarator)
        {
            continue;
        }
        ResolveChildren(*child);
        const std::string_view name = m_Tokens.Text(child->token);
        for (std::uint32_t i = child->token + 1; i < child->end; ++i)
        {
            // Its own value names another one: glslang takes it for the new.
            if (m_Tokens.Text(i) == name && m_Tokens.Text(i - 1) != ".")
            {
                Rename(*child);
                break;
            }
        }
        Declare(name, {child, nullptr, child->type});
    }
}

void HlslResolver::Rename(HlslNode& declarator)
{
    if (std::find(m_Renamed.begin(), m_Renamed.end(), &declarator) == m_Renamed.end())
    {
        m_Renamed.push_back(&declarator);
    }
}

void HlslResolver::ResolveChildren(HlslNode& node)
{
    for (HlslNode* child = node.child; child; child = child->next)
    {
        ResolveExpression(*child);
    }
}

void HlslResolver::ResolveExpression(HlslNode& node)
{
    ResolveChildren(node);
    const auto first = [&]
    {
        return node.child ? node.child->type : HlslType();
    };
    const auto arguments = [&](HlslNode* child)
    {
        std::vector<HlslType> types;
        for (; child; child = child->next)
        {
            types.push_back(child->type);
        }
        return types;
    };
    switch (node.kind)
    {
    case HlslNodeKind::Name:
        ResolveName(node);
        break;
    case HlslNodeKind::Call:
        node.type = CallType(node, arguments(node.child));
        break;
    case HlslNodeKind::Method:
    {
        const std::string_view name = m_Tokens.Text(node.token);
        const auto methods = m_Globals.FindMethods(name, first());
        const auto types = arguments(node.child->next);
        const HlslFunction* method = ChooseOverload(m_Globals.declarations(), methods, types);
        node.type =
            first().kind == HlslType::Kind::Object ? ObjectMethodType(first(), name)
            : method ? TypeOf(m_Globals.declarations(), method->returnType, method->returnArgument)
                     : HlslType();
        break;
    }
    case HlslNodeKind::Member:
        node.type = MemberType(node);
        break;
    case HlslNodeKind::Index:
        node.type = ElementType(first());
        break;
    case HlslNodeKind::Prefix:
        node.type = m_Tokens.Text(node.token) == "!" && first().isNumber()
                        ? first().Of(HlslScalar::Bool)
                        : first();
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
        Rename(*meant.local);
    }
    node.local = meant.local;
    node.variable = meant.variable;
    node.type = meant.type;
}

/// The newest, unless that is the number of a loop that is over, where a number cannot be meant.
const HlslResolver::Entry& HlslResolver::Meant(const std::vector<Entry>& entries, bool hasMembers)
{
    const auto lasting = std::find_if(entries.rbegin(), entries.rend(),
                                      [](const Entry& entry) { return !entry.hasEnded; });
    const bool isOther = entries.back().hasEnded && lasting != entries.rend() &&
                         (hasMembers || !lasting->type.isNumber());
    return isOther ? *lasting : entries.back();
}

HlslType HlslResolver::CallType(const HlslNode& node, std::span<const HlslType> arguments)
{
    const std::string_view name = m_Tokens.Text(node.token);
    auto functions = m_Globals.FindFunctions(name);
    functions = functions.empty() ? m_Globals.FindMethods(name) : functions;
    if (functions.empty())
    {
        if (!isIntrinsic(name))
        {
            m_Unknown.push_back({node.token, "no matching overloaded function found"});
        }
        return IntrinsicType(name, arguments);
    }
    const HlslFunction* function = ChooseOverload(m_Globals.declarations(), functions, arguments);
    return function
               ? TypeOf(m_Globals.declarations(), function->returnType, function->returnArgument)
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
    const auto isName = [&](const HlslVariable& item)
    {
        return item.name == name;
    };
    const auto member = std::find_if(type->members.begin(), type->members.end(), isName);
    if (member == type->members.end())
    {
        m_Unknown.push_back({node.token, "no such field in structure"});
        return {};
    }
    return TypeOf(m_Globals.declarations(), *member);
}

HlslType HlslResolver::ObjectMethodType(const HlslType& object, std::string_view method) const
{
    const bool isElement = method == "Load" && object.name.find("StructuredBuffer") != method.npos;
    return isElement ? TypeOf(m_Globals.declarations(), object.element, {})
                     : MethodType(object, method);
}

HlslType HlslResolver::BinaryType(const HlslNode& node) const
{
    constexpr std::array<std::string_view, 8> k_Truths = {"==", "!=", "<",  ">",
                                                          "<=", ">=", "&&", "||"};
    const HlslType& left = node.child->type;
    const HlslType& right = node.child->next ? node.child->next->type : HlslType();
    const std::string_view text = m_Tokens.Text(node.token);
    if (text == ",")
    {
        return right;
    }
    const HlslType both = Promote(left, right);
    if (std::find(k_Truths.begin(), k_Truths.end(), text) != k_Truths.end())
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
