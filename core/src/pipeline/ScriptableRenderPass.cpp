#include <limn/core/CoreUtils.h>
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

void ScriptableRenderPass::Blit(CommandBuffer& cmd, RenderTargetIdentifier source,
                                RenderTargetIdentifier destination,
                                std::shared_ptr<const Material> material, int passIndex) const
{
    if (m_ClearFlag & ClearFlag::Color)
    {
        cmd.SetRenderTarget(destination);
        cmd.ClearRenderTarget(ClearFlag::Color, m_ClearColor);
    }
    if (material)
    {
        cmd.Blit(std::move(source), std::move(destination), std::move(material), passIndex);
        return;
    }
    cmd.Blit(std::move(source), std::move(destination));
}

void ScriptableRenderPass::Blit(CommandBuffer& cmd, const RTHandle& source,
                                const RTHandle& destination,
                                std::shared_ptr<const Material> material, int passIndex) const
{
    if (material)
    {
        Blitter::BlitCameraTexture(cmd, source, destination, std::move(material), passIndex);
        return;
    }
    cmd.Blit(RenderTargetIdentifier(source), RenderTargetIdentifier(destination));
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
