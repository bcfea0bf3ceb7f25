#pragma once

#include <limn/core/Inspector.h>
#include <limn/core/PluginCallSite.h>
#include <limn/core/ScriptableRendererFeature.h>

namespace limn
{

/// The feature's Describe, which may be a plug-in's.
inline void DescribeFeature(ScriptableRendererFeature& feature, Inspector& inspector)
{
    RunPluginCode(typeid(feature), feature.name, "Describe", [&] { feature.Describe(inspector); });
}

} // namespace limn
