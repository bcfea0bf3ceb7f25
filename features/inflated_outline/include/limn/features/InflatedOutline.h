#pragma once

#include <limn/features/OutlineComponent.h>

namespace limn
{

/// The unit of the thickness of an inflated hull.
enum class InflatedWidthUnit
{
    Pixels, ///< on the screen, whatever the distance
    Metres  ///< in the world, as in the article: thinner far away
};

/// The volume parameters of the outline of InflatedOutlineRendererFeature.
class InflatedOutline final : public OutlineComponent
{
public:
    EnumParameter<InflatedWidthUnit> m_WidthUnit{
        this,
        "m_WidthUnit",
        InflatedWidthUnit::Pixels,
        {{"Pixels", InflatedWidthUnit::Pixels}, {"Metres", InflatedWidthUnit::Metres}},
        {.tooltip =
             "The unit of the width: Pixels takes m_OutlineWidth, Metres takes m_WidthInMetres."}};
    MinFloatParameter m_WidthInMetres{
        this,
        "m_WidthInMetres",
        0.02f,
        0.0f,
        {.tooltip = "The distance of the hull from its object, in the world.", .unit = "m"}};

    /// Returns the greatest reach of the outline, in pixels. For a width in metres it is a
    /// constant, because the number of pixels per metre depends on the object: hulls that reach in
    /// from farther outside of the picture than a quarter of a large screen are not drawn.
    float reach() const override
    {
        return m_WidthUnit.value() == InflatedWidthUnit::Metres ? 1024.0f : m_OutlineWidth.value();
    }
};

} // namespace limn
