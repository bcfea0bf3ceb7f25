#pragma once

#include <limn/core/PluginCallSite.h>
#include <limn/core/ScriptableRenderer.h>

namespace limn
{

/// Calls `work`, which is code of a pass, as RunPluginCode does.
/// @param name  the name of what failed: the pass's own, or that of a pass of its render graph
template <typename Work>
decltype(auto) RunPassCode(const ScriptableRenderer& renderer, const ScriptableRenderPass& pass,
                           std::string_view name, const char* member, Work&& work)
{
    try
    {
        return std::forward<Work>(work)();
    }
    catch (...)
    {
        PluginCallSite code{typeid(pass), name, member};
        if (const ScriptableRendererFeature* feature = renderer.FeatureOf(pass))
        {
            code.featureOfPass = feature->name;
            code.typeOfFeature = &typeid(*feature);
        }
        detail::TellOfPluginCode(code);
        throw;
    }
}

template <typename Work>
decltype(auto) RunPassCode(const ScriptableRenderer& renderer, const ScriptableRenderPass& pass,
                           const char* member, Work&& work)
{
    return RunPassCode(renderer, pass, pass.profilingSampler.name(), member,
                       std::forward<Work>(work));
}

} // namespace limn
