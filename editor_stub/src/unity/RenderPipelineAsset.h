#pragma once

#include <limn/editor_stub/SceneFile.h>
#include <optional>

namespace limn
{

/// Loads the values that limn takes from a render pipeline asset as Unity saves it: m_MSAA,
/// m_SupportsHDR, m_HDRColorBufferPrecision, m_RenderScale, m_AdditionalLightsPerObjectLimit, which
/// is 0 if m_AdditionalLightsRenderingMode is Disabled, and those of shadows. Values that the asset
/// lacks are Unity's defaults. The version is the project's by its Packages/manifest.json, else the
/// one that k_AssetVersion tells.
/// Unity: UnityEngine.Rendering.Universal.UniversalRenderPipelineAsset (URP 14).
/// @param pipelineVersion  the version if neither is known
/// @throws AssetError if the file is no such asset, or if it has a value that Unity does not save
PipelineSettings LoadUnityRenderPipeline(const std::filesystem::path& path, AssetContext& assets,
                                         int pipelineVersion);

/// Returns the major version of URP that the Unity project around a file asks for in its
/// Packages/manifest.json, or nothing if that names none of 7 to 17.
std::optional<int> ProjectPipelineVersion(const std::filesystem::path& file, AssetContext& assets);

} // namespace limn
