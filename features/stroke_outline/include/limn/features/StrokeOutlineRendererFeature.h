#pragma once

#include <limn/features/OutlineRendererFeature.h>
#include <limn/features/StrokeOutline.h>
#include <limn/features/StrokeOutlinePass.h>

namespace limn
{

/// Draws the outline as a geometric shape: all points outside of an object that are no farther away
/// than the width. The coverage of a pixel is the part of it that the shape covers.
/// @source silhouette edges: McGuire, Hughes, "Hardware-Determined Feature Edges" (NPAR 2004)
class StrokeOutlineRendererFeature final
    : public OutlineRendererFeature<StrokeOutline, StrokeOutlineSettings, StrokeOutlinePass>
{
public:
    explicit StrokeOutlineRendererFeature(StrokeOutlineSettings settings = {})
        : OutlineRendererFeature(settings)
    {
        name = "StrokeOutlineRendererFeature";
    }
};

} // namespace limn
