#pragma once

#include <limn/volume/NumberParameters.h>
#include <limn/volume/VolumeComponent.h>

namespace limn
{

/// Fades the picture towards its corners. Unity: Vignette (URP 14).
class Vignette final : public VolumeComponent, public IPostProcessComponent
{
public:
    ColorParameter color{this, "color", Color::black, false, false, true};
    Vector2Parameter center{
        this,
        "center",
        glm::vec2(0.5f),
        {.tooltip = "The point where nothing fades, 0...1 from the picture's bottom left corner."}};
    ClampedFloatParameter intensity{
        this, "intensity",
        0.0f, 0.0f,
        1.0f, {.tooltip = "The distance to which the fading reaches inwards; 0 draws none."}};
    ClampedFloatParameter smoothness{
        this, "smoothness", 0.2f, 0.01f, 1.0f, {.tooltip = "The softness of its border."}};
    BoolParameter rounded{this,
                          "rounded",
                          false,
                          {.tooltip = "Makes it a circle, whatever the shape of the picture is."}};

    bool IsActive() const override { return intensity.value() > 0.0f; }
    bool IsTileCompatible() const override { return true; }
};

} // namespace limn
