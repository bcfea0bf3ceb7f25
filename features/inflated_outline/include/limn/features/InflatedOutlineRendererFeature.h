#pragma once

#include <limn/features/InflatedOutlinePass.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

/// The settings for when and around which objects the outline is drawn. By default these are opaque
/// objects, before transparent ones are drawn in front of them, because the objects are drawn once
/// more.
struct InflatedOutlineSettings : OutlineSettings
{
    InflatedOutlineSettings()
    {
        m_RenderPassEvent = RenderPassEvent::AfterRenderingOpaques;
        m_RenderQueueRange = OutlineRenderQueueRange::Opaque;
    }

    OutlineGrouping m_Grouping = OutlineGrouping::PerGroup;

    void Describe(Inspector& inspector);
};

/// Draws a hull around each object before the object. This is the oldest outline, and the cheapest
/// where few pixels must be shaded.
/// @source technique 1 of the introduction of the article on selection outlines
class InflatedOutlineRendererFeature final
    : public OutlineRendererFeature<InflatedOutline, InflatedOutlineSettings, InflatedOutlinePass>
{
public:
    explicit InflatedOutlineRendererFeature(InflatedOutlineSettings settings = {})
        : OutlineRendererFeature(settings)
    {
        name = "InflatedOutlineRendererFeature";
    }
};

} // namespace limn
