#pragma once

#include <limn/features/OutlineComponent.h>

namespace limn
{

/// The volume parameters of the lines of MaskDifferenceOutlineRendererFeature. The width is the
/// distance of the compared neighbours; a line has this width on both sides of a silhouette.
class MaskDifferenceOutline final : public OutlineComponent
{
public:
    /// The greatest width, in pixels. Farther neighbours say nothing about a silhouette; a greater
    /// width is drawn this wide.
    static constexpr float k_WidestWidth = 256.0f; // pixels

    MinFloatParameter outline_depth_threshold_clip_player{
        this,
        "outline_depth_threshold_clip_player",
        2.0f,
        0.0f,
        {.tooltip = "No line where the scene's depth is this or more; the near plane is 0, the far "
                    "plane 1, and above 1 there are lines everywhere."}};
    MinFloatParameter m_ClipDistance{
        this,
        "m_ClipDistance",
        0.0f,
        0.0f,
        {.tooltip = "The same as a distance from the camera: no line where the scene is this far "
                    "away or farther; 0 = lines everywhere. The nearer of the two counts.",
         .unit = "metres"}};

    /// Returns the reach in whole pixels, because the mask is read texel by texel.
    float reach() const override;
};

} // namespace limn
