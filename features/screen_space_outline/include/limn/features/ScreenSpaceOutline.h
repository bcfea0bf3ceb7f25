#pragma once

#include <limn/volume/NumberParameters.h>
#include <limn/volume/VolumeComponent.h>

namespace limn
{

/// The colour and width of the screen-space outline, which volumes set.
/// @source nscTechArt/URP-Screen-Space-Outline, ScreenSpaceOutline.cs (Unity 2022.3)
class ScreenSpaceOutline final : public VolumeComponent, public IPostProcessComponent
{
public:
    BoolParameter m_Enable{this, "m_Enable", false, {.tooltip = "Draws the outline."}};
    ColorParameter m_OutlineColor{
        this,
        "m_OutlineColor",
        Color::white,
        {.tooltip = "The colour in sRGB, which is added to the picture."}};
    ClampedFloatParameter m_OutlineWidth{
        this,  "m_OutlineWidth",
        3.0f,  1.0f,
        10.0f, {.tooltip = "The width of the outline.", .unit = "pixels"}};

    bool IsActive() const override { return m_Enable.value(); }
    bool IsTileCompatible() const override { return false; }
};

} // namespace limn
