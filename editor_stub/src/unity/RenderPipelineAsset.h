#pragma once

#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/YamlNode.h>
#include <optional>

namespace limn
{

/// The values that limn takes from a render pipeline asset as Unity saves it.
/// Unity: UnityEngine.Rendering.Universal.UniversalRenderPipelineAsset (URP 14).
struct UnityRenderPipeline
{
    int msaaSampleCount = 1; ///< m_MSAA: 1, 2, 4 or 8 samples a pixel
    bool supportsHDR = true; ///< m_SupportsHDR
    /// m_HDRColorBufferPrecision; 32 bits, Unity's default, if the asset is older than the key
    HDRColorBufferPrecision hdrColorBufferPrecision = HDRColorBufferPrecision::_32Bits;
    float renderScale = 1.0f; ///< m_RenderScale, 0.1 ... 2
    /// m_AdditionalLightsPerObjectLimit, 0 ... 8; 0 if m_AdditionalLightsRenderingMode is Disabled
    int maxAdditionalLightsCount = 4;
    /// The project's version by its Packages/manifest.json, else the one that k_AssetVersion tells;
    /// nothing if neither is known.
    std::optional<int> pipelineVersion;
    ShadowSettings shadows; ///< m_ShadowDistance and the like; missing values are Unity's defaults
};

/// @throws AssetError if the file is no such asset, or if it has a value that Unity does not save
UnityRenderPipeline LoadUnityRenderPipeline(const std::filesystem::path& path,
                                            AssetContext& assets);

/// Gives a scene the settings of its pipeline.
void Apply(const UnityRenderPipeline& pipeline, SceneAsset& scene);

/// Returns the major version of URP that the Unity project around a file asks for in its
/// Packages/manifest.json, or nothing if that names none of 7 to 17.
std::optional<int> ProjectPipelineVersion(const std::filesystem::path& file, AssetContext& assets);

/// Returns the major version of URP by the k_AssetVersion of a UniversalRenderPipelineAsset, or
/// nothing without that field. Unity raises k_AssetVersion when the asset's form changes; among
/// versions of URP that share one, the last is returned.
std::optional<int> PipelineVersionOf(const YamlNode& pipelineFields);

} // namespace limn
