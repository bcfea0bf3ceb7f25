#pragma once

#include <limn/features/OutlineRendererFeature.h>
#include <limn/features/WideOutlineRenderPass.h>

namespace limn
{

/// Outlines of any width, exact to what the mask of four samples a pixel knows of the silhouette.
/// Technique: B. Golus, "The Quest for Very Wide Outlines" (2020); columns and rows after
/// Felzenszwalb and Huttenlocher (2012), limited to the width.
class WideOutlineRendererFeature final
    : public OutlineRendererFeature<WideOutline, WideOutlineSettings, WideOutlineRenderPass>
{
public:
    using OutlineRendererFeature::OutlineRendererFeature;
};

} // namespace limn
