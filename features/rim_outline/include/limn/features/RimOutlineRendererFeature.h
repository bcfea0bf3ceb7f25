#pragma once

#include <limn/features/OutlineRendererFeature.h>
#include <limn/features/RimOutlinePass.h>

namespace limn
{

/// The settings for when and on which objects the rim is drawn. By default these are opaque
/// objects, whose depth shows which parts are seen, before transparent ones are drawn in front of
/// them.
struct RimOutlineSettings : OutlineSettings
{
    RimOutlineSettings()
    {
        m_RenderPassEvent = RenderPassEvent::AfterRenderingOpaques;
        m_RenderQueueRange = OutlineRenderQueueRange::Opaque;
    }
};

/// Draws a glow along the inside of each object's silhouette, computed from the angle between
/// normal and line of sight. It needs no texture and no second picture, and has no exact width.
/// @source technique 2 of the introduction of the article on selection outlines
class RimOutlineRendererFeature final
    : public OutlineRendererFeature<RimOutline, RimOutlineSettings, RimOutlinePass>
{
public:
    explicit RimOutlineRendererFeature(RimOutlineSettings settings = {})
        : OutlineRendererFeature(settings)
    {
        name = "RimOutlineRendererFeature";
    }
};

} // namespace limn
