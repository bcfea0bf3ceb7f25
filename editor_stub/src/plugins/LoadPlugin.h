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

/// Loads a plug-in, registers what it holds and adds its shaders to ShippedShaders(). It stays
/// loaded until the process ends, since whoever got an object of it runs its code; its file is read
/// once, however often it is asked for. From then on what its code throws is an AssetError that
/// names it.
/// @throws AssetError if there is no such file, it is no library, no plug-in, one for another limn,
///     its registration throws, or a name of it is taken
void LoadPlugin(const std::filesystem::path& path, FeatureRegistry& features,
                VolumeComponentRegistry& components, PluginLoading loading = PluginLoading::File);

/// Reads a loaded plug-in's file again: LoadPlugin then registers what it holds now, and its
/// shaders take the place of the older ones. Objects of the older one go on with the older code. Of
/// a file that could not be loaded so far nothing is read.
/// @throws AssetError as LoadPlugin; all then stays as it was
void ReloadPlugin(const std::filesystem::path& path);

/// The files on disk that the shaders of loaded plug-ins were embedded from, each with its
/// plug-in's path: a change of one shows only once the plug-in is built again.
std::map<std::filesystem::path, std::string> EmbeddedShaderFiles();

/// The feature's Describe, which may be a plug-in's.
inline void DescribeFeature(ScriptableRendererFeature& feature, Inspector& inspector)
{
    RunPluginCode(typeid(feature), feature.name, "Describe", [&] { feature.Describe(inspector); });
}

} // namespace limn
