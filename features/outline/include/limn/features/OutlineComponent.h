#pragma once

#include <glm/vec2.hpp>
#include <limn/volume/NumberParameters.h>
#include <limn/volume/ValueParameters.h>
#include <limn/volume/VolumeComponent.h>

namespace limn
{

/// What volumes set of an outline, whatever the technique. A technique derives its own component.
class OutlineComponent : public VolumeComponent, public IPostProcessComponent
{
public:
    BoolParameter m_Enable{this, "m_Enable", false, {.tooltip = "Draws the outline."}};
    ColorParameter m_OutlineColor{
        this, "m_OutlineColor", Color::white, {.tooltip = "sRGB; alpha is how opaque it is."}};
    MinFloatParameter m_OutlineWidth{
        this,
        "m_OutlineWidth",
        3.0f,
        0.0f,
        {.tooltip = "How wide the outline is; 0 draws nothing.", .unit = "pixels"}};

    bool IsActive() const override { return m_Enable.value(); }
    bool IsTileCompatible() const override { return false; }

    /// How far from its object the outline may reach, pixels.
    virtual float reach() const { return m_OutlineWidth.value(); }

    /// The width, but no more than the picture's diagonal, beyond which nothing changes.
    float WidthWithin(const glm::ivec2& picture) const;
};

/// Why the blended component draws nothing, "" if it does.
/// @param component  null = not registered
/// @param name       as profiles call it
std::string WhyInactive(const OutlineComponent* component, std::string_view name);

} // namespace limn
