#pragma once

#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/YamlNode.h>
#include <optional>

namespace limn
{

/// What limn takes from a render pipeline asset as Unity saves it.
/// Unity: UnityEngine.Rendering.Universal.UniversalRenderPipelineAsset (URP 14).
struct UnityRenderPipeline
{
    int msaaSampleCount = 1; ///< m_MSAA: 1, 2, 4 or 8 samples a pixel
    bool supportsHDR = true; ///< m_SupportsHDR
    /// m_HDRColorBufferPrecision; 32 bits, Unity's default, where the asset is older than the key
    HDRColorBufferPrecision hdrColorBufferPrecision = HDRColorBufferPrecision::_32Bits;
    float renderScale = 1.0f; ///< m_RenderScale, 0.1 ... 2
    /// m_AdditionalLightsPerObjectLimit, 0 ... 8; 0 where m_AdditionalLightsRenderingMode is
    /// Disabled
    int maxAdditionalLightsCount = 4;
    /// The project's, by its Packages/manifest.json, or that which k_AssetVersion tells; else none
    std::optional<int> pipelineVersion;
    ShadowSettings shadows; ///< m_ShadowDistance and its like; what it lacks is Unity's default
};

/// @throws AssetError if the file is no such asset, or a value is none that Unity saves
UnityRenderPipeline LoadUnityRenderPipeline(const std::filesystem::path& path,
                                            AssetContext& assets);

/// Gives a scene the settings of its pipeline.
void Apply(const UnityRenderPipeline& pipeline, SceneAsset& scene);

/// The major version of URP that the Unity project around a file asks for, by the project's
/// Packages/manifest.json; nothing if that names none of 7 to 17.
std::optional<int> ProjectPipelineVersion(const std::filesystem::path& file, AssetContext& assets);

/// The major version of URP by the k_AssetVersion of a UniversalRenderPipelineAsset, of those that
/// share one the last: Unity raises it where the asset's form changes. Nothing without the field.
std::optional<int> PipelineVersionOf(const YamlNode& pipelineFields);

} // namespace limn
