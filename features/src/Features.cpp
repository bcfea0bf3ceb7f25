#include <limn/core/BuiltinShaders.h>
#include <limn/features/Features.h>
#include <limn/features/Plugin.h>
#include <set>

namespace limn
{

namespace embedded
{
std::span<const EmbeddedFile> FeatureShaders();
}

void RegisterVolumeComponents(VolumeComponentRegistry& registry)
{
    FeatureRegistry features;
    RegisterFeatures(features, registry);
}

namespace
{

/// Grows while plug-ins are loaded.
ShaderDatabase& AllShaders()
{
    static ShaderDatabase shaders = []
    {
        ShaderDatabase database = BuiltinShaders();
        database.Add(embedded::FeatureShaders());
        return database;
    }();
    return shaders;
}

} // namespace

const ShaderDatabase& ShippedShaders()
{
    return AllShaders();
}

void AddPlugin(const Plugin& plugin, FeatureRegistry& features, VolumeComponentRegistry& components)
{
    static std::set<const Plugin*> added; // their shaders, once for all registries
    ShaderDatabase shaders;
    if (plugin.shaders && added.count(&plugin) == 0)
    {
        shaders.Add(plugin.shaders());
    }
    for (const std::string_view name : shaders.names())
    {
        if (AllShaders().Find(name))
        {
            throw ContractError("a shader '" + std::string(name) + "' is there already");
        }
    }
    plugin.registerFeatures(features, components);
    AllShaders().Add(shaders);
    added.insert(&plugin);
}

} // namespace limn
