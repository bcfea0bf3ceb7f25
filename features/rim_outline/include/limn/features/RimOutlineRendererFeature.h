#pragma once

#include <limn/features/OutlineRendererFeature.h>
#include <limn/features/RimOutlinePass.h>

namespace limn
{

/// When and on which objects the rim is drawn: opaque ones, which leave the depth by which it knows
/// what is seen, before transparent ones come in front of them.
struct RimOutlineSettings : OutlineSettings
{
    RimOutlineSettings()
    {
        m_RenderPassEvent = RenderPassEvent::AfterRenderingOpaques;
        m_RenderQueueRange = OutlineRenderQueueRange::Opaque;
    }
};

/// A glow along the inside of each object's silhouette, from the angle between normal and line of
/// sight: no texture, no second picture, and no exact width.
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
