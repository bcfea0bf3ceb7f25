#pragma once

#include <limn/features/InflatedOutlinePass.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

/// When and around which objects the outline is drawn. Opaque ones, before transparent ones come in
/// front of them: the objects are drawn once more.
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

/// A hull around each object, drawn before the object: the oldest outline, and the cheapest where
/// few pixels are to be shaded.
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
