#pragma once

#include <filesystem>
#include <limn/core/Inspector.h>
#include <limn/core/PluginCallSite.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <limn/editor_stub/AssetContext.h>
#include <map>
#include <string>

namespace limn
{

/// An exception that left the code of a plug-in's feature, of one of its passes, or of a volume
/// component.
class PluginError : public AssetError
{
public:
    PluginError(std::vector<Diagnostic> diagnostics, std::string_view name)
        : AssetError(std::move(diagnostics)), feature(name)
    {
    }

    const std::string feature; ///< the name of the feature, or of the component
};

/// Loads a plug-in, registers its features and components and adds its shaders to ShippedShaders().
/// It stays loaded until the process ends, since owners of its objects run its code. Its file is
/// read once, however often it is asked for. From then on, an exception of its code is a
/// PluginError, which names the plug-in.
/// @throws AssetError if there is no such file, if it is no library, no plug-in or a plug-in for
///     another limn, if its registration throws, or if one of its names is taken
void LoadPlugin(const std::filesystem::path& path, FeatureRegistry& features,
                VolumeComponentRegistry& components, PluginLoading loading = PluginLoading::File);

/// Reads a loaded plug-in's file again. LoadPlugin then registers what the file holds now, and its
/// shaders replace the older ones. Objects of the older plug-in go on with the older code. Does not
/// read a file that could not be loaded so far.
/// @throws AssetError as LoadPlugin; everything then stays as it was
void ReloadPlugin(const std::filesystem::path& path);

/// Returns the files on disk from which the shaders of loaded plug-ins were embedded, each with its
/// plug-in's path. A change of such a file shows only after the plug-in is built again.
std::map<std::filesystem::path, std::string> EmbeddedShaderFiles();

/// Calls the feature's Describe, which may be a plug-in's code.
inline void DescribeFeature(ScriptableRendererFeature& feature, Inspector& inspector)
{
    RunPluginCode(typeid(feature), feature.name, "Describe", [&] { feature.Describe(inspector); });
}

} // namespace limn
