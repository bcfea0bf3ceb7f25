#pragma once

#include <limn/features/OutlineRendererFeature.h>
#include <limn/features/StrokeOutline.h>
#include <limn/features/StrokeOutlinePass.h>

namespace limn
{

/// The outline as a geometric shape: all points outside of an object that are no farther than the
/// width from it, each pixel covered by as much of it as lies in the pixel.
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
