#pragma once

#include <limn/features/OutlineComponent.h>

namespace limn
{

/// What the lines of MaskDifferenceOutlineRendererFeature look like, as volumes set it. The width
/// is how far the compared neighbours are away: a line is so wide on both sides of a silhouette.
class MaskDifferenceOutline final : public OutlineComponent
{
public:
    /// Farther neighbours say nothing about a silhouette; what is wider is drawn this wide.
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

    /// Whole pixels: the mask is read texel by texel.
    float reach() const override;
};

} // namespace limn
