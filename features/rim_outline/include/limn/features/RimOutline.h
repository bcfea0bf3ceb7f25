#pragma once

#include <limn/features/OutlineComponent.h>

namespace limn
{

/// The parts of a surface that are its rim; theta is the angle between normal and line of sight.
enum class RimVariant
{
    Soft,      ///< the whole surface, as strongly as the sine of theta
    Threshold, ///< parts where theta is above an angle
    Pixels ///< parts within a distance from the silhouette in pixels, estimated from the curvature
};

/// The volume parameters of the rim of RimOutlineRendererFeature.
class RimOutline final : public OutlineComponent
{
public:
    EnumParameter<RimVariant> m_Variant{
        this,
        "m_Variant",
        RimVariant::Soft,
        {{"Soft", RimVariant::Soft},
         {"Threshold", RimVariant::Threshold},
         {"Pixels", RimVariant::Pixels}},
        {.tooltip = "The extent of the rim: Soft fades with m_Falloff, Threshold ends at "
                    "m_ThresholdAngle, Pixels ends at m_OutlineWidth."}};
    ClampedFloatParameter m_Falloff{
        this,
        "m_Falloff",
        1.0f,
        0.1f,
        64.0f,
        {.tooltip = "The power to which the sine is raised; 1 is the article's, a greater one "
                    "makes the rim narrower."}};
    ClampedFloatParameter m_ThresholdAngle{
        this,
        "m_ThresholdAngle",
        70.0f,
        0.0f,
        90.0f,
        {.tooltip = "The angle between normal and line of sight above which the rim begins.",
         .unit = "degrees"}};

    /// Returns a positive number where the rim is drawn and 0 where it is not. The rim lies within
    /// its objects.
    float reach() const override
    {
        return m_Variant.value() == RimVariant::Pixels ? m_OutlineWidth.value() : 1.0f;
    }
};

} // namespace limn
