#include "hlsl/lowering/Lowering.h"

#include <algorithm>

namespace limn
{

namespace
{

/// The variable that `a.b[i].xy` is a part of.
const HlslNode& RootOf(const HlslNode& target)
{
    const HlslNode* node = &target;
    while (node->child && (node->kind == HlslNodeKind::Member ||
                           node->kind == HlslNodeKind::Index || node->kind == HlslNodeKind::Paren))
    {
        node = node->child;
    }
    return *node;
}

/// Whether a function of the name gives something back by the parameter at the index.
bool isGivenBack(std::span<const HlslFunction* const> functions, std::size_t index)
{
    return std::any_of(functions.begin(), functions.end(),
                       [&](const HlslFunction* function)
                       {
                           return index < function->parameters.size() &&
                                  (function->parameters[index].Has("out") ||
                                   function->parameters[index].Has("inout"));
                       });
}

} // namespace

void FindWrittenUniforms(const HlslNode& root, const HlslTokens& tokens, const HlslGlobals& globals,
                         std::set<const HlslVariable*>& written)
{
    const auto write = [&](const HlslNode& target)
    {
        const HlslNode& variable = RootOf(target);
        if (variable.kind == HlslNodeKind::Name && !variable.local &&
            globals.isUniform(variable.variable))
        {
            written.insert(variable.variable);
        }
    };
    const std::string_view text = tokens.Text(root.token);
    const bool isStep = text == "++" || text == "--";
    if (root.kind == HlslNodeKind::Assign ||
        (isStep && (root.kind == HlslNodeKind::Prefix || root.kind == HlslNodeKind::Postfix)))
    {
        write(*root.child);
    }
    const bool isMethod = root.kind == HlslNodeKind::Method;
    std::size_t index = 0;
    const HlslNode* const first = isMethod ? root.child->next : root.child;
    for (const HlslNode* argument = first; argument; argument = argument->next, ++index)
    {
        const bool isCall = isMethod || root.kind == HlslNodeKind::Call;
        if (isCall && (isGivenBack(globals.FindFunctions(text), index) ||
                       isGivenBack(globals.FindMethods(text), index)))
        {
            write(*argument);
        }
    }
    for (const HlslNode* child = root.child; child; child = child->next)
    {
        FindWrittenUniforms(*child, tokens, globals, written);
    }
}

} // namespace limn
