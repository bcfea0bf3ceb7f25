#pragma once

#include <limn/volume/NumberParameters.h>
#include <limn/volume/VolumeComponent.h>

namespace limn
{

/// Adjusts exposure, contrast, tint, hue and saturation of the whole picture.
/// Unity: ColorAdjustments (URP 14).
class ColorAdjustments final : public VolumeComponent, public IPostProcessComponent
{
public:
    FloatParameter postExposure{this,
                                "postExposure",
                                0.0f,
                                {.tooltip = "The change of brightness after all other effects; 1 "
                                            "makes the picture twice as bright.",
                                 .unit = "EV"}};
    ClampedFloatParameter contrast{this, "contrast", 0.0f, -100.0f, 100.0f, {.unit = "percent"}};
    ColorParameter colorFilter{this, "colorFilter", Color::white, true, false, true};
    ClampedFloatParameter hueShift{this, "hueShift", 0.0f, -180.0f, 180.0f, {.unit = "degrees"}};
    ClampedFloatParameter saturation{this,    "saturation", 0.0f,
                                     -100.0f, 100.0f,       {.unit = "percent"}};

    bool IsActive() const override
    {
        return postExposure.value() != 0.0f || contrast.value() != 0.0f ||
               colorFilter.value() != Color::white || hueShift.value() != 0.0f ||
               saturation.value() != 0.0f;
    }
    bool IsTileCompatible() const override { return true; }
};

} // namespace limn
