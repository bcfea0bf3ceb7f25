#pragma once

#include <limn/features/DepthNormalsOutlinePass.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

/// The settings for which objects get lines: opaque ones, because others are in neither texture,
/// before transparent ones are drawn over them.
struct DepthNormalsOutlineSettings : OutlineSettings
{
    DepthNormalsOutlineSettings()
    {
        m_RenderPassEvent = RenderPassEvent::AfterRenderingOpaques;
        m_RenderQueueRange = OutlineRenderQueueRange::Opaque;
    }
};

/// Draws lines on chosen objects where the depth or the normals of the picture change: at
/// silhouettes and creases.
/// @source the article on outlining objects one by one, whose shader graph does it in their
/// material
class DepthNormalsOutlineRendererFeature final
    : public OutlineRendererFeature<DepthNormalsOutline, DepthNormalsOutlineSettings,
                                    DepthNormalsOutlinePass>
{
public:
    explicit DepthNormalsOutlineRendererFeature(DepthNormalsOutlineSettings settings = {})
        : OutlineRendererFeature(settings)
    {
        name = "DepthNormalsOutlineRendererFeature";
    }
};

} // namespace limn
