#pragma once

#include <limn/features/OutlineComponent.h>
#include <limn/volume/NumberParameters.h>

namespace limn
{

/// The volume parameters of the selection outline; the defaults give the article's outline.
/// @source OutlineEffect of the article on outlines of selected objects (Unity)
class SelectionOutline final : public OutlineComponent
{
public:
    SelectionOutline();

    BoolParameter m_VaryingColor{
        this,
        "m_VaryingColor",
        true,
        {.tooltip = "Colour and alpha vary with time, each object's from when it was selected; "
                    "false: m_OutlineColor."}};
    MinFloatParameter offsetScale{
        this,
        "offsetScale",
        0.0f,
        0.0f,
        {.tooltip = "How far a blur looks along both axes; 0: as far as makes the outline reach "
                    "m_OutlineWidth, 2 for 14.",
         .unit = "pixels"}};
    ClampedIntParameter iterate{
        this, "iterate", 3, 0, 64, {.tooltip = "The blur runs once and twice as often as this."}};
    ClampedFloatParameter outlineStrength{
        this,
        "outlineStrength",
        3.0f,
        1.0f,
        5.0f,
        {.tooltip = "What the blurred colour is multiplied by, since at most half of it is seen."}};

    /// Returns how often the blur runs.
    int blurCount() const { return 2 * iterate.value() + 1; }
    /// Returns the offset of the taps in pixels: offsetScale, or the one that m_OutlineWidth
    /// requires.
    float tapOffset() const;
    float reach() const override { return tapOffset() * static_cast<float>(blurCount()); }
};

} // namespace limn
