#pragma once

#include <limn/features/OutlineRendererFeature.h>
#include <limn/features/WideOutlineRenderPass.h>

namespace limn
{

/// Draws outlines of any width, as exact as the mask with four samples per pixel shows the
/// silhouette. Technique: B. Golus, "The Quest for Very Wide Outlines" (2020); columns and rows
/// after Felzenszwalb and Huttenlocher (2012), limited to the width.
class WideOutlineRendererFeature final
    : public OutlineRendererFeature<WideOutline, WideOutlineSettings, WideOutlineRenderPass>
{
public:
    using OutlineRendererFeature::OutlineRendererFeature;
};

} // namespace limn
