#pragma once

#include <limn/core/ScriptableRenderPass.h>

namespace limn
{

/// Draws the objects of a range of queues with those passes of their own materials that have one of
/// some LightModes. Unity: UnityEngine.Rendering.Universal.Internal.DrawObjectsPass (URP 14), and
/// its prepasses.
class DrawObjectsPass final : public ScriptableRenderPass
{
public:
    DrawObjectsPass(const char* name, RenderPassEvent event, std::vector<ShaderTagId> tags,
                    RenderQueueRange queues, SortingCriteria sorting)
        : m_Tags(std::move(tags)), m_Filtering(queues), m_Sorting(sorting)
    {
        profilingSampler = ProfilingSampler(name);
        renderPassEvent = event;
    }

    void SetLayerMask(LayerMask layers) { m_Filtering.layerMask = layers; }

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override
    {
        SetAlphaToMaskAvailable(context, renderingData);
        const DrawingSettings drawing = CreateDrawingSettings(m_Tags, renderingData, m_Sorting);
        context.DrawRenderers(renderingData.cullResults, drawing, m_Filtering);
    }

private:
    /// Sets the value by which shaders decide whether to sharpen their alpha for AlphaToMask; it is
    /// 0 unless it is set.
    void SetAlphaToMaskAvailable(ScriptableRenderContext& context, const RenderingData& data) const
    {
        if (data.cameraData.cameraTargetDescriptor.msaaSamples > 1 && !overrideCameraTarget())
        {
            const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
            const bool isOpaque = m_Filtering.renderQueueRange == RenderQueueRange::opaque;
            cmd->SetGlobalFloat(ShaderPropertyId("_AlphaToMaskAvailable"), isOpaque ? 1.0f : 0.0f);
            context.ExecuteCommandBuffer(*cmd);
        }
    }

    std::vector<ShaderTagId> m_Tags;
    FilteringSettings m_Filtering;
    SortingCriteria m_Sorting;
};

} // namespace limn
