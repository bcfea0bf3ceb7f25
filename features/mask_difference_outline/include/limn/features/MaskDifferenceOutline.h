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
        {.tooltip = "The depth from which on no line is drawn; the near plane is at 0, the far "
                    "plane at 1, and a value above 1 draws lines everywhere."}};
    MinFloatParameter m_ClipDistance{
        this,
        "m_ClipDistance",
        0.0f,
        0.0f,
        {.tooltip = "The distance from the camera from which on no line is drawn; 0 draws lines "
                    "everywhere. The nearer of the two limits counts.",
         .unit = "metres"}};

    /// Returns the reach in whole pixels, because the mask is read texel by texel.
    float reach() const override;
};

} // namespace limn
