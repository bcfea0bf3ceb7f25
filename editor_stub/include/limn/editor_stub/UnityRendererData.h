#pragma once

#include <limn/editor_stub/SceneFile.h>

namespace limn
{

struct UnityRendererDataLoadResult
{
    RendererAsset renderer;
    std::vector<Diagnostic> notes; ///< what was left out or replaced, with Severity::Note
};

/// Loads the features, with their settings, and the layer masks of a renderer asset as Unity saves
/// it. Scripts and shaders are found by guid in the .meta files of the Unity project that the asset
/// is in: the nearest folder above it that has an Assets folder. Features and settings that limn
/// does not know become notes. A shader that is not in the project becomes a note too; the shader
/// of the same file name that comes with limn takes its place.
/// Unity: UnityEngine.Rendering.Universal.UniversalRendererData (URP 14).
///
/// @throws AssetError if the file is no such asset, or with every value that does not fit its
///     setting
UnityRendererDataLoadResult LoadUnityRendererData(const std::filesystem::path& path,
                                                  AssetContext& assets);

} // namespace limn
