#pragma once

#include <limn/features/OutlineComponent.h>

namespace limn
{

/// The volume parameters of the selection outline; the defaults give the article's outline.
/// @source OutlineEffect of the article on outlines of selected objects (Unity)
class SelectionOutline final : public OutlineComponent
{
public:
    SelectionOutline();

    BoolParameter m_VaryingColor{this,
                                 "m_VaryingColor",
                                 true,
                                 {.tooltip = "On: the colour of each object varies with the time "
                                             "since it was selected; off: it is m_OutlineColor."}};
    MinFloatParameter offsetScale{
        this,
        "offsetScale",
        0.0f,
        0.0f,
        {.tooltip = "The distance of the blur's samples along both axes; with 0 the outline "
                    "reaches m_OutlineWidth, for 14 the distance is 2.",
         .unit = "pixels"}};
    ClampedIntParameter iterate{
        this,
        "iterate",
        3,
        0,
        64,
        {.tooltip = "The number of iterations; the blur runs twice as often, and once more."}};
    ClampedFloatParameter outlineStrength{
        this, "outlineStrength",
        3.0f, 1.0f,
        5.0f, {.tooltip = "The factor of the blurred colour; at most half of it is seen."}};

    /// Returns how often the blur runs.
    int blurCount() const { return 2 * iterate.value() + 1; }
    /// Returns the offset of the taps in pixels: offsetScale, or the one that m_OutlineWidth
    /// requires.
    float tapOffset() const;
    float reach() const override { return tapOffset() * static_cast<float>(blurCount()); }
};

} // namespace limn
