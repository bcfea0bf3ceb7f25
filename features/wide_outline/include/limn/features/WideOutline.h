#pragma once

#include <limn/features/OutlineComponent.h>

namespace limn
{

/// The place of a wide outline: outside of the silhouette, inside, or half of it on either side.
enum class WideOutlineSide
{
    Outer,
    Inner,
    Centred
};

/// The volume parameters of a wide outline.
class WideOutline final : public OutlineComponent
{
public:
    EnumParameter<WideOutlineSide> m_Side{
        this,
        "m_Side",
        WideOutlineSide::Outer,
        {{"Outer", WideOutlineSide::Outer},
         {"Inner", WideOutlineSide::Inner},
         {"Centred", WideOutlineSide::Centred}},
        {.tooltip = "The side of the silhouette on which the outline lies."}};
    MinFloatParameter m_Gap{
        this,
        "m_Gap",
        0.0f,
        0.0f,
        {.tooltip = "The distance between the silhouette and the outline.", .unit = "pixels"}};
    ClampedFloatParameter m_Gradient{
        this, "m_Gradient",
        0.0f, 0.0f,
        1.0f, {.tooltip = "The share of m_OuterColor at the far end of the outline."}};
    ColorParameter m_OuterColor{this,
                                "m_OuterColor",
                                Color::black,
                                {.tooltip = "The colour in sRGB at the far end of the outline."}};
    MinFloatParameter m_Falloff{this,
                                "m_Falloff",
                                0.0f,
                                0.0f,
                                {.tooltip = "The fading of a glow: alpha falls to 0 at the far "
                                            "end, evenly for 1, sooner for more; 0 draws a line."}};

    float reach() const override;
};

} // namespace limn
