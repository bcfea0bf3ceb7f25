#include "passes/MakeDrawingSettings.h"

#include <limn/core/CoreUtils.h>
#include <limn/core/ScriptableRenderPass.h>
#include <limn/core/ScriptableRenderer.h>

namespace limn
{

void ScriptableRenderPass::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    renderingData.cameraData.renderer->RecordRenderGraph(*this, context, renderingData);
    if (!m_RecordsGraph)
    {
        throw ContractError("pass '" + profilingSampler.name() +
                            "' overrides neither Execute nor RecordRenderGraph");
    }
}

void ScriptableRenderPass::RecordRenderGraph(RenderGraph&, ContextContainer&)
{
    m_RecordsGraph = false;
}

const RTHandle& ScriptableRenderPass::colorAttachmentHandle() const
{
    static const RTHandle none;
    return m_Colors.empty() ? none : m_Colors.front();
}

void ScriptableRenderPass::ConfigureTarget(const RTHandle& color, const RTHandle& depth)
{
    const bool isDepth = color.rt() && !depth && IsDepthFormat(color.rt()->graphicsFormat());
    ConfigureTarget(std::span(&color, isDepth ? 0u : 1u), isDepth ? color : depth);
}

void ScriptableRenderPass::ConfigureTarget(std::span<const RTHandle> colors, const RTHandle& depth)
{
    while (!colors.empty() && !colors.back())
    {
        colors = colors.first(colors.size() - 1);
    }
    if (colors.size() > k_MostColors)
    {
        throw ContractError("ConfigureTarget: it was given " + std::to_string(colors.size()) +
                            " colour targets; a pass has at most " + std::to_string(k_MostColors));
    }
    m_OverrideCameraTarget = true;
    m_Colors.assign(colors.begin(), colors.end());
    m_Depth = depth;
}

void ScriptableRenderPass::ConfigureTarget(RenderTargetIdentifier color,
                                           RenderTargetIdentifier depth)
{
    ConfigureTarget(RTHandles::Alloc(std::move(color)), RTHandles::Alloc(std::move(depth)));
}

void ScriptableRenderPass::ConfigureTarget(std::span<const RenderTargetIdentifier> colors)
{
    std::vector<RTHandle> handles;
    for (const RenderTargetIdentifier& color : colors)
    {
        handles.push_back(RTHandles::Alloc(color));
    }
    ConfigureTarget(handles);
}

void ScriptableRenderPass::ConfigureTarget(std::span<const RenderTargetIdentifier> colors,
                                           RenderTargetIdentifier depth)
{
    ConfigureTarget(colors);
    m_Depth = RTHandles::Alloc(std::move(depth));
}

void ScriptableRenderPass::ConfigureClear(ClearFlag clearFlag, const Color& clearColor)
{
    m_ClearFlag = clearFlag;
    m_ClearColor = clearColor;
}

void ScriptableRenderPass::ResetTarget()
{
    m_OverrideCameraTarget = false;
    m_Colors.clear();
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

void ScriptableRenderPass::Blit(CommandBuffer& cmd, RenderingData& data,
                                std::shared_ptr<const Material> material, int passIndex) const
{
    ScriptableRenderer& renderer = *data.cameraData.renderer;
    Blitter::BlitCameraTexture(cmd, renderer.cameraColorTargetHandle(),
                               renderer.GetCameraColorFrontBuffer(), std::move(material),
                               passIndex);
    renderer.SwapColorBuffer(cmd);
}

DrawingSettings ScriptableRenderPass::CreateDrawingSettings(std::span<const ShaderTagId> tags,
                                                            const RenderingData& renderingData,
                                                            SortingCriteria sortingCriteria) const
{
    return MakeDrawingSettings(tags, *renderingData.cameraData.camera, sortingCriteria);
}

static DistanceMetric MetricOf(const Camera& camera)
{
    switch (camera.transparencySortMode)
    {
    case TransparencySortMode::Perspective:
        return DistanceMetric::Perspective;
    case TransparencySortMode::Orthographic:
        return DistanceMetric::Orthographic;
    case TransparencySortMode::CustomAxis:
        return DistanceMetric::CustomAxis;
    case TransparencySortMode::Default:
        break;
    }
    return camera.orthographic ? DistanceMetric::Orthographic : DistanceMetric::Perspective;
}

DrawingSettings MakeDrawingSettings(std::span<const ShaderTagId> tags, const Camera& camera,
                                    SortingCriteria sortingCriteria)
{
    if (tags.empty() || tags.size() > DrawingSettings::maxShaderPasses)
    {
        throw ContractError("CreateDrawingSettings: it was given " + std::to_string(tags.size()) +
                            " LightMode tags; 1 to 16 are expected");
    }
    DrawingSettings settings;
    settings.shaderTagIds.assign(tags.begin(), tags.end());
    settings.sortingSettings = {sortingCriteria, glm::dvec3(camera.transform.worldMatrix()[3]),
                                camera.transform.forward(), MetricOf(camera),
                                camera.transparencySortAxis};
    return settings;
}

DrawingSettings ScriptableRenderPass::CreateDrawingSettings(ShaderTagId tag,
                                                            const RenderingData& renderingData,
                                                            SortingCriteria sortingCriteria) const
{
    return CreateDrawingSettings(std::span(&tag, 1), renderingData, sortingCriteria);
}

void ScriptableRendererFeature::SetupRenderPasses(ScriptableRenderer&, const RenderingData&) {}

} // namespace limn
