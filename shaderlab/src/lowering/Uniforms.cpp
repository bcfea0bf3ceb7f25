#include "lowering/Lowering.h"

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

/// Returns whether a function of this name has an out or inout parameter at the index.
bool isGivenBack(std::span<const HlslFunction* const> functions, std::size_t index)
{
    return std::ranges::any_of(
        functions, [&](const HlslFunction* function)
        { return index < function->parameters.size() && function->parameters[index].isOutput(); });
}

} // namespace

void FindWrittenUniforms(const HlslNode& node, const HlslTokens& tokens, const HlslGlobals& globals,
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
    const std::string_view text = tokens.Text(node.token);
    const bool isStep = text == "++" || text == "--";
    if (node.kind == HlslNodeKind::Assign ||
        (isStep && (node.kind == HlslNodeKind::Prefix || node.kind == HlslNodeKind::Postfix)))
    {
        write(*node.child);
    }
    const bool isCall = node.kind == HlslNodeKind::Method || node.kind == HlslNodeKind::Call;
    const HlslNode* argument = isCall ? node.FirstArgument() : nullptr;
    for (std::size_t index = 0; argument; argument = argument->next, ++index)
    {
        if (isGivenBack(globals.FindFunctions(text), index) ||
            isGivenBack(globals.FindMethods(text), index))
        {
            write(*argument);
        }
    }
}

} // namespace limn
