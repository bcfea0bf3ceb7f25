#pragma once

#include <glm/vec2.hpp>
#include <limn/core/ShaderId.h>
#include <limn/volume/NumberParameters.h>
#include <limn/volume/VolumeComponent.h>

namespace limn
{

/// The names under which shaders read what OutlineComponent gives.
namespace OutlineShaderIDs
{
inline const ShaderPropertyId _OutlineColor{"_OutlineColor"};
inline const ShaderPropertyId _OutlineWidth{"_OutlineWidth"};
} // namespace OutlineShaderIDs

/// The volume parameters that all outline techniques have in common. A technique derives its own
/// component.
class OutlineComponent : public VolumeComponent, public IPostProcessComponent
{
public:
    BoolParameter m_Enable{this, "m_Enable", false, {.tooltip = "Draws the outline."}};
    ColorParameter m_OutlineColor{this,
                                  "m_OutlineColor",
                                  Color::white,
                                  {.tooltip = "The colour in sRGB; its alpha is the opacity."}};
    MinFloatParameter m_OutlineWidth{
        this,
        "m_OutlineWidth",
        3.0f,
        0.0f,
        {.tooltip = "The width of the outline; 0 draws nothing.", .unit = "pixels"}};

    bool IsActive() const override { return m_Enable.value(); }
    bool IsTileCompatible() const override { return false; }

    /// Returns the greatest distance of the outline from its object, in pixels.
    virtual float reach() const { return m_OutlineWidth.value(); }

    /// Returns the width, limited to the picture's diagonal; a greater width changes nothing.
    float WidthWithin(const glm::ivec2& picture) const;
};

/// Returns why a blended component leaves its effect off, or "" if it is active.
/// @param enable  its m_Enable; null = the component is not registered
/// @param name    its name in profiles
std::string WhyOff(const BoolParameter* enable, bool isActive, std::string_view name);

/// Returns why the blended component draws nothing, or "" if it draws.
/// @param component  null = not registered
/// @param name       its name in profiles
std::string WhyInactive(const OutlineComponent* component, std::string_view name);

} // namespace limn
