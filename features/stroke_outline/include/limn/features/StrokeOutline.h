#pragma once

#include <limn/features/OutlineComponent.h>

namespace limn
{

/// The volume parameters of the exact outline.
class StrokeOutline final : public OutlineComponent
{
public:
    ColorParameter m_OccludedColor{
        this,
        "m_OccludedColor",
        Color{0.5f, 0.5f, 0.5f, 1.0f},
        {.tooltip =
             "The colour in sRGB of the hidden parts, if the feature's occlusion is SeeThrough."}};
};

} // namespace limn
