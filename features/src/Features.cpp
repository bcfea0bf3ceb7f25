#include <limn/core/BuiltinShaders.h>
#include <limn/features/Features.h>
#include <limn/features/Plugin.h>
#include <limn/features/ShippedComputeShaders.h>
#include <limn/shaderlab/EmbeddedIncludes.h>
#include <limn/shaderlab/ShaderLabParser.h>
#include <map>

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

struct Shipped
{
    ShaderDatabase own;
    std::map<const Plugin*, ShaderDatabase> ofPlugins; ///< once for all registries
    ShaderDatabase all;
};

Shipped& AllShaders()
{
    static Shipped shipped = []
    {
        ShaderDatabase own = BuiltinShaders();
        own.Add(embedded::FeatureShaders());
        return Shipped{own, {}, own};
    }();
    return shipped;
}

/// @throws AssetError if it does not parse
std::shared_ptr<const ShaderLabDocument> Parsed(const EmbeddedFile& file, const std::string& name)
{
    return std::make_shared<const ShaderLabDocument>(
        ParseShaderLab(file.text, name).TakeDocument());
}

/// Returns the shaders that a plug-in contains. No other plug-in may have them.
ShaderDatabase ShadersOf(const Plugin& plugin, const Plugin* older)
{
    ShaderDatabase shaders;
    for (const EmbeddedFile& file :
         plugin.shaders ? plugin.shaders() : std::span<const EmbeddedFile>())
    {
        if (file.path.ends_with(".shader"))
        {
            shaders.Add(Parsed(file, std::string(plugin.name) + "/" + std::string(file.path)));
        }
    }
    const auto olderOnes = AllShaders().ofPlugins.find(older);
    for (const std::string_view name : shaders.names())
    {
        const ShaderLabDocument* known = AllShaders().all.Find(name);
        const bool makesWay =
            olderOnes != AllShaders().ofPlugins.end() && olderOnes->second.Find(name) == known;
        if (known && !makesWay)
        {
            throw ContractError("a shader '" + std::string(name) + "' is there already");
        }
    }
    return shaders;
}

} // namespace

const ShaderDatabase& ShippedShaders()
{
    return AllShaders().all;
}

std::shared_ptr<const Shader> FindShippedShader(std::string_view name,
                                                const std::shared_ptr<ShaderCompiler>& compiler)
{
    std::shared_ptr<const Shader> shader = Shader::Find(name, ShippedShaders(), compiler);
    if (!shader)
    {
        throw ContractError("limn has no shader " + ShippedShaders().UnknownShader(name));
    }
    return shader;
}

void AddPlugin(const Plugin& plugin, FeatureRegistry& features, VolumeComponentRegistry& components,
               const Plugin* older)
{
    Shipped& shipped = AllShaders();
    const bool isAdded = shipped.ofPlugins.count(&plugin) > 0;
    ShaderDatabase shaders = isAdded ? ShaderDatabase() : ShadersOf(plugin, older);
    plugin.registerFeatures(features, components);
    if (isAdded)
    {
        return;
    }
    if (plugin.shaders)
    {
        SetEmbeddedIncludes(plugin.name, plugin.shaders());
    }
    shipped.ofPlugins.erase(older);
    shipped.ofPlugins.emplace(&plugin, std::move(shaders));
    shipped.all = shipped.own;
    for (const auto& [unused, ofPlugin] : shipped.ofPlugins)
    {
        shipped.all.Add(ofPlugin);
    }
}

std::shared_ptr<ComputeShader> FindShippedComputeShader(std::string_view fileName,
                                                        std::shared_ptr<ShaderCompiler> compiler)
{
    for (const auto& [plugin, unused] : AllShaders().ofPlugins)
    {
        for (const EmbeddedFile& file :
             plugin->shaders ? plugin->shaders() : std::span<const EmbeddedFile>())
        {
            if (file.path.ends_with(".compute") &&
                file.path.substr(file.path.rfind('/') + 1) == fileName)
            {
                return ComputeShader::FromText(
                    file.text, std::string(plugin->name) + "/" + std::string(file.path),
                    std::move(compiler));
            }
        }
    }
    return nullptr;
}

} // namespace limn
