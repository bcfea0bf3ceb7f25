#pragma once

#include <hlsl/Resolver.h>
#include <hlsl/TreeParser.h>
#include <lowering/Lowering.h>
#include <lowering/StageLowering.h>

#include <string>

namespace limn::test
{

/// A function of a text, read and resolved.
class ResolvedBody
{
public:
    ResolvedBody(const HlslSource& source, const HlslFunction& function)
        : m_Resolver(source.tokens, source.globals)
    {
        HlslTreeParser parser(source.tokens, source.declarations, m_Nodes);
        m_Root = parser.ParseBlock(function.body);
        m_Resolver.ResolveBody(*m_Root, function, nullptr);
    }

    HlslNode& root() { return *m_Root; }
    const HlslNodes& nodes() const { return m_Nodes; }
    const HlslResolver& resolver() const { return m_Resolver; }

private:
    HlslNodes m_Nodes;
    HlslResolver m_Resolver;
    HlslNode* m_Root = nullptr;
};

/// The text after lowering all its functions, what they need before it.
inline std::string Lowered(const std::string& text)
{
    const HlslSource source(text);
    TokenEdits code(source.tokens);
    HlslLowering lowering(code, source.globals);
    for (const HlslFunction& function : source.declarations.functions)
    {
        if (function.hasBody)
        {
            ResolvedBody body(source, function);
            lowering.Rename(body.resolver(), body.nodes());
            lowering.Lower(body.root(), false);
        }
    }
    return lowering.functions() + code.Assemble();
}

} // namespace limn::test
