#pragma once

#include <limn/core/FilteringSettings.h>
#include <limn/core/RenderPassEvent.h>

namespace limn
{

class Inspector;

enum class OutlineRenderQueueRange
{
    All,
    Opaque,
    Transparent
};

/// Which objects get one silhouette together.
enum class OutlineGrouping
{
    Together, ///< all that are outlined
    PerGroup, ///< those below one object without parent
    PerObject
};

/// When and around which objects an outline is drawn: what all techniques have in common.
struct OutlineSettings
{
    RenderPassEvent m_RenderPassEvent = RenderPassEvent::AfterRenderingTransparents;
    OutlineRenderQueueRange m_RenderQueueRange = OutlineRenderQueueRange::All;
    LayerMask m_LayerMask = LayerMask::Everything();
    int m_RenderingLayerMask = 0; ///< an index 0...31, not bits, as in the article's feature

    /// Returns the rendering layer of that index, for a renderer to be outlined:
    /// `renderer.renderingLayerMask = settings.renderingLayer()`.
    /// @throws ContractError if m_RenderingLayerMask is outside 0...31
    RenderingLayerMask renderingLayer() const
    {
        return RenderingLayerMask::FromIndex(m_RenderingLayerMask);
    }

    void Describe(Inspector& inspector);
    /// @throws ContractError if m_RenderingLayerMask or m_RenderQueueRange is outside its range
    FilteringSettings filtering() const;
};

/// Says a setting of this type to an inspector.
void DescribeGrouping(Inspector& inspector, OutlineGrouping& grouping);

} // namespace limn
