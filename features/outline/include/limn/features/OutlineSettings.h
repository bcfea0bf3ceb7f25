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

/// @throws ContractError for any other number
RenderQueueRange ToRenderQueueRange(OutlineRenderQueueRange range);

/// The grouping of objects; the objects of a group have one common silhouette.
enum class OutlineGrouping
{
    Together, ///< all outlined objects
    PerGroup, ///< the objects below one object without parent
    PerObject
};

/// The settings that all techniques have in common: when and around which objects an outline is
/// drawn.
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

/// The settings of a technique that draws over the outlined objects, which are opaque.
struct OpaqueOutlineSettings : OutlineSettings
{
    OpaqueOutlineSettings()
    {
        m_RenderPassEvent = RenderPassEvent::AfterRenderingOpaques;
        m_RenderQueueRange = OutlineRenderQueueRange::Opaque;
    }
};

/// Describes the settings that select the outlined objects to an inspector.
void DescribeFilter(Inspector& inspector, OutlineRenderQueueRange& renderQueueRange,
                    LayerMask& layerMask, int& renderingLayerMask);
/// Describes a setting of this type to an inspector.
void DescribeGrouping(Inspector& inspector, OutlineGrouping& grouping);

} // namespace limn
