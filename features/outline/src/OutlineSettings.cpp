#include <limn/core/Inspector.h>
#include <limn/core/PipelineState.h>
#include <limn/features/OutlineSettings.h>

namespace limn
{

namespace
{

constexpr EnumEntry k_OutlineQueueRanges[] = {{"All", 0}, {"Opaque", 1}, {"Transparent", 2}};
constexpr EnumEntry k_Groupings[] = {{"Together", 0}, {"PerGroup", 1}, {"PerObject", 2}};

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

} // namespace

void OutlineSettings::Describe(Inspector& inspector)
{
    inspector.Header("Basic Settings");
    inspector.Field("m_RenderPassEvent", m_RenderPassEvent,
                    "The event of the frame at which the outline is drawn");

    inspector.Header("Filtering Settings");
    inspector.Field("m_RenderQueueRange", m_RenderQueueRange, k_OutlineQueueRanges,
                    "The render queues of the objects that are outlined");
    inspector.Field("m_LayerMask", m_LayerMask, "The layers of the objects that are outlined");
    inspector.RenderingLayerIndex("m_RenderingLayerMask", m_RenderingLayerMask,
                                  "The rendering layer that marks an object as selected");
}

FilteringSettings OutlineSettings::filtering() const
{
    return FilteringSettings(ToRenderQueueRange(m_RenderQueueRange), m_LayerMask, renderingLayer());
}

void DescribeGrouping(Inspector& inspector, OutlineGrouping& grouping)
{
    inspector.Field(
        "m_Grouping", grouping, k_Groupings,
        "The objects that share one silhouette: all, those of a hierarchy, or each alone");
}

} // namespace limn
