#include "lowering/Lowering.h"

#include <algorithm>
#include <string>
#include <vector>

namespace limn
{

namespace
{

bool isOfLoop(const HlslNode& declarator)
{
    const HlslNode* declaration = declarator.parent;
    const HlslNode* loop = declaration ? declaration->parent : nullptr;
    return loop && loop->kind == HlslNodeKind::For && loop->child == declaration;
}

/// The statement around a loop that a declaration may stand before.
const HlslNode& StatementOf(const HlslNode& loop)
{
    const HlslNode* statement = &loop;
    while (statement->parent && statement->parent->kind != HlslNodeKind::Block)
    {
        statement = statement->parent;
    }
    return *statement;
}

} // namespace

void HlslLowering::Rename(const HlslResolver& resolver, const HlslNodes& nodes)
{
    if (resolver.renamed().empty())
    {
        return; // as nearly always
    }
    std::set<const HlslNode*> renamed(resolver.renamed().begin(), resolver.renamed().end());
    std::vector<const HlslNode*> loops;
    for (const HlslNode* declarator : resolver.renamed())
    {
        // All that the loop declares is hoisted, and must not meet others of its name.
        const HlslNode* const loop = isOfLoop(*declarator) ? declarator->parent->parent : nullptr;
        if (!loop || std::ranges::find(loops, loop) != loops.end())
        {
            continue;
        }
        loops.push_back(loop);
        for (const HlslNode* name = loop->child->child; name; name = name->next)
        {
            renamed.insert(name);
        }
    }
    const auto spell = [&](const HlslNode& declarator, std::size_t token)
    {
        m_Code.Spelling(token) =
            "limn_" + std::string(Text(declarator.token)) + std::to_string(declarator.token);
    };
    for (const HlslNode& node : nodes)
    {
        if (node.kind == HlslNodeKind::Declarator && renamed.contains(&node))
        {
            spell(node, node.token);
        }
        else if (node.kind == HlslNodeKind::Name && renamed.contains(node.local))
        {
            spell(*node.local, node.token);
        }
    }
    for (const HlslNode* loop : loops)
    {
        Hoist(*loop);
    }
}

/// `for (int i = 0; …)` becomes `int i; for (i = 0; …)`, all its variables with it.
void HlslLowering::Hoist(const HlslNode& loop)
{
    const HlslNode& declaration = *loop.child;
    std::string names;
    for (const HlslNode* name = declaration.child; name; name = name->next)
    {
        if (name->kind != HlslNodeKind::Declarator)
        {
            return;
        }
        names += (names.empty() ? " " : ", ") + m_Code.Spelling(name->token);
    }
    const std::string type(m_Code.Span(declaration.token, declaration.child->first));
    m_Code.Erase(declaration.first, declaration.child->first);
    m_Code.Spelling(StatementOf(loop).first).insert(0, type + names + "; ");
}

} // namespace limn
