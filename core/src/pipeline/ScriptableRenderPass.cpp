#include <limn/core/ScriptableRenderPass.h>
#include <limn/core/ScriptableRendererFeature.h>

namespace limn
{

void ScriptableRenderPass::OnCameraSetup(CommandBuffer&, RenderingData&) {}

void ScriptableRenderPass::Configure(CommandBuffer&, const RenderTextureDescriptor&) {}

void ScriptableRenderPass::OnCameraCleanup(CommandBuffer&) {}

void ScriptableRenderPass::ConfigureTarget(const RTHandle& color, const RTHandle& depth)
{
    const bool isDepth = color && !depth && IsDepthFormat(color.rt()->graphicsFormat());
    m_OverrideCameraTarget = true;
    m_Color = isDepth ? RTHandle() : color;
    m_Depth = isDepth ? color : depth;
}

void ScriptableRenderPass::ConfigureClear(ClearFlag clearFlag, const Color& clearColor)
{
    m_ClearFlag = clearFlag;
    m_ClearColor = clearColor;
}

void ScriptableRenderPass::ResetTarget()
{
    m_OverrideCameraTarget = false;
    m_Color.Release();
    m_Depth.Release();
}

DrawingSettings ScriptableRenderPass::CreateDrawingSettings(std::span<const ShaderTagId> tags,
                                                            const RenderingData& renderingData,
                                                            SortingCriteria sortingCriteria) const
{
    if (tags.empty() || tags.size() > DrawingSettings::maxShaderPasses)
    {
        throw ContractError("CreateDrawingSettings: " + std::to_string(tags.size()) +
                            " LightMode tags; give 1 to 16");
    }
    const Camera& camera = *renderingData.cameraData.camera;
    DrawingSettings settings;
    settings.shaderTagIds.assign(tags.begin(), tags.end());
    settings.sortingSettings = {
        sortingCriteria, glm::dvec3(camera.transform.worldMatrix()[3]), camera.transform.forward(),
        camera.orthographic ? DistanceMetric::Orthographic : DistanceMetric::Perspective};
    return settings;
}

DrawingSettings ScriptableRenderPass::CreateDrawingSettings(ShaderTagId tag,
                                                            const RenderingData& renderingData,
                                                            SortingCriteria sortingCriteria) const
{
    return CreateDrawingSettings(std::span(&tag, 1), renderingData, sortingCriteria);
}

void ScriptableRendererFeature::SetupRenderPasses(ScriptableRenderer&, const RenderingData&) {}

float ScriptableRendererFeature::cullingMargin(const VolumeStackPointer&) const
{
    return 0.0f;
}

void ScriptableRendererFeature::Describe(Inspector&) {}

} // namespace limn
