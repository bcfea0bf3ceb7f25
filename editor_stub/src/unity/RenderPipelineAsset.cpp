#include "unity/RenderPipelineAsset.h"

#include "settings/Keys.h"
#include "settings/ReadEnum.h"
#include "settings/ShadowKeys.h"
#include "unity/PipelineVersion.h"

#include <limn/volume/UnityAsset.h>

namespace limn
{

namespace
{

/// Disabled is as good as a limit of none.
void ReadLightMode(const YamlNode& node, UnityRenderPipeline& pipeline,
                   AssetDiagnostics& diagnostics)
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

} // namespace

UnityRenderPipeline LoadUnityRenderPipeline(const std::filesystem::path& path, AssetContext& assets)
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
    UnityRenderPipeline pipeline;
    pipeline.msaaSampleCount = count.value_or(1);
    pipeline.pipelineVersion = ProjectPipelineVersion(path, assets);
    if (!pipeline.pipelineVersion)
    {
        pipeline.pipelineVersion = PipelineVersionOf(root->fields);
    }
    pipeline.shadows.softShadowsSupported = false; // Unity's defaults
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

} // namespace limn
