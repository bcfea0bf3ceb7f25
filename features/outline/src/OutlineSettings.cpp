#include <limn/core/Inspector.h>
#include <limn/core/PipelineState.h>
#include <limn/features/OutlineSettings.h>

namespace limn
{

namespace
{

constexpr EnumEntry k_OutlineQueueRanges[] = {{"All", 0}, {"Opaque", 1}, {"Transparent", 2}};
constexpr EnumEntry k_Groupings[] = {{"Together", 0}, {"PerGroup", 1}, {"PerObject", 2}};

} // namespace

RenderQueueRange ToRenderQueueRange(OutlineRenderQueueRange range)
{
    switch (range)
    {
    case OutlineRenderQueueRange::All:
        return RenderQueueRange::all;
    case OutlineRenderQueueRange::Opaque:
        return RenderQueueRange::opaque;
    case OutlineRenderQueueRange::Transparent:
        return RenderQueueRange::transparent;
    }
    throw ContractError("m_RenderQueueRange is " + std::to_string(static_cast<int>(range)) +
                        "; it must be All 0, Opaque 1 or Transparent 2");
}

void OutlineSettings::Describe(Inspector& inspector)
{
    inspector.Header("Basic Settings");
    inspector.Field("m_RenderPassEvent", m_RenderPassEvent,
                    "The event of the frame at which the outline is drawn");
    DescribeFilter(inspector, m_RenderQueueRange, m_LayerMask, m_RenderingLayerMask);
}

FilteringSettings OutlineSettings::filtering() const
{
    return FilteringSettings(ToRenderQueueRange(m_RenderQueueRange), m_LayerMask, renderingLayer());
}

void DescribeFilter(Inspector& inspector, OutlineRenderQueueRange& renderQueueRange,
                    LayerMask& layerMask, int& renderingLayerMask)
{
    inspector.Header("Filtering Settings");
    inspector.Field("m_RenderQueueRange", renderQueueRange, k_OutlineQueueRanges,
                    "The render queues of the objects that are outlined");
    inspector.Field("m_LayerMask", layerMask, "The layers of the objects that are outlined");
    inspector.RenderingLayerIndex("m_RenderingLayerMask", renderingLayerMask,
                                  "The rendering layer that marks an object as selected");
}

void DescribeGrouping(Inspector& inspector, OutlineGrouping& grouping)
{
    inspector.Field(
        "m_Grouping", grouping, k_Groupings,
        "The objects that share one silhouette: all, those of a hierarchy, or each alone");
}

} // namespace limn
