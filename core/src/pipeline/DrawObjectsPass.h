#pragma once

#include <limn/core/ScriptableRenderPass.h>

namespace limn
{

/// Draws the objects of a queue range with those passes of their own materials that have one of
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
        const DrawingSettings drawing = CreateDrawingSettings(m_Tags, renderingData, m_Sorting);
        context.DrawRenderers(renderingData.cullResults, drawing, m_Filtering);
    }

private:
    std::vector<ShaderTagId> m_Tags;
    FilteringSettings m_Filtering;
    SortingCriteria m_Sorting;
};

} // namespace limn
