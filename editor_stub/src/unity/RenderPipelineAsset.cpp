#include "unity/RenderPipelineAsset.h"

#include "settings/Keys.h"
#include "settings/ReadValues.h"
#include "settings/ShadowKeys.h"
#include "unity/UnityProject.h"

#include <limn/shaderlab/FindPackages.h>
#include <limn/volume/UnityAsset.h>
#include <limn/volume/YamlRead.h>

namespace limn
{

namespace
{

/// Disabled is as good as a limit of none.
void ReadLightMode(const YamlNode& node, PipelineSettings& pipeline, AssetDiagnostics& diagnostics)
{
    constexpr std::string_view k_Key = "m_AdditionalLightsRenderingMode";
    const std::optional<int> mode = ReadEnum(node, k_LightRenderingModes, k_Key, diagnostics);
    if (mode == k_PerVertexLights)
    {
        diagnostics.Error(node.location(),
                          std::string(k_Key) + ": PerVertex is not drawn; set PerPixel");
    }
    else if (mode == k_NoAdditionalLights)
    {
        pipeline.maxAdditionalLightsCount = 0;
    }
}

/// Returns the major version of URP by the k_AssetVersion of a UniversalRenderPipelineAsset, or
/// nothing without that field. Unity raises k_AssetVersion when the asset's form changes; among
/// versions of URP that share one, the last is returned.
std::optional<int> PipelineVersionOf(const YamlNode& pipelineFields)
{
    const YamlNode* node = pipelineFields.Find("k_AssetVersion");
    AssetDiagnostics ignored("");
    const std::optional<int> version = node ? ReadInt(*node, "", ignored) : std::nullopt;
    if (!version)
    {
        return std::nullopt;
    }
    return *version < 9 ? 11 : *version == 9 ? 12 : *version == 10 ? 13 : *version == 11 ? 14 : 17;
}

} // namespace

PipelineSettings LoadUnityRenderPipeline(const std::filesystem::path& path, AssetContext& assets,
                                         int pipelineVersion)
{
    assets.Reach(path);
    const AssetContext::RootsFor roots(assets, path);
    const std::optional<UnityObject> root = LoadUnityAsset(path).FindWithField("m_MSAA");
    if (!root)
    {
        throw AssetError(path.generic_string(), {},
                         "no render pipeline in this Unity asset; one is a MonoBehaviour with a "
                         "number 'm_MSAA'");
    }
    AssetDiagnostics diagnostics(path.generic_string());
    const std::optional<int> count =
        ReadEnum(*root->fields.Find("m_MSAA"), k_MsaaQualities, "m_MSAA", diagnostics);
    PipelineSettings pipeline;
    pipeline.msaaSampleCount = count.value_or(1);
    const std::optional<int> version = ProjectPipelineVersion(path, assets);
    pipeline.pipelineVersion =
        version ? *version : PipelineVersionOf(root->fields).value_or(pipelineVersion);
    pipeline.hdrColorBufferPrecision = HDRColorBufferPrecision::_32Bits; // older than the key
    pipeline.shadows.softShadowsSupported = false;                       // Unity's defaults
    pipeline.shadows.additionalLightShadowsSupported = false;
    YamlMapReader fields(root->fields, "", diagnostics); // it has many more
    fields.Read("m_SupportsHDR", pipeline.supportsHDR);
    if (const YamlNode* node = fields.Find("m_HDRColorBufferPrecision"))
    {
        pipeline.hdrColorBufferPrecision = static_cast<HDRColorBufferPrecision>(
            ReadEnum(*node, k_HdrPrecisions, "m_HDRColorBufferPrecision", diagnostics).value_or(0));
    }
    fields.Read("m_RenderScale", pipeline.renderScale, scene_keys::k_RenderScales);
    fields.Read("m_AdditionalLightsPerObjectLimit", pipeline.maxAdditionalLightsCount,
                scene_keys::k_LightLimits);
    if (const YamlNode* node = root->fields.Find("m_AdditionalLightsRenderingMode"))
    {
        ReadLightMode(*node, pipeline, diagnostics);
    }
    ReadShadowSettings(fields, pipeline.shadows, diagnostics);
    diagnostics.ThrowIfErrors();
    return pipeline;
}

std::optional<int> ProjectPipelineVersion(const std::filesystem::path& file, AssetContext& assets)
{
    const std::filesystem::path root = UnityProjectAround(file);
    if (root.empty())
    {
        return std::nullopt;
    }
    const std::filesystem::path manifest = root / "Packages" / "manifest.json";
    assets.Reach(manifest);
    const auto version = MajorVersionAskedFor(manifest, "com.unity.render-pipelines.universal");
    const bool isKnown = version && *version >= scene_keys::k_PipelineVersions.min &&
                         *version <= scene_keys::k_PipelineVersions.max;
    return isKnown ? version : std::nullopt;
}

} // namespace limn
