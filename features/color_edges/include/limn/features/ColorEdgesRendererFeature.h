#pragma once

#include <limn/features/ColorEdgesPass.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

/// When the lines are drawn, and where.
struct ColorEdgesSettings : OutlineSettings
{
    /// Lines only where a filtered object is seen; without it, all over the picture, whatever the
    /// filter.
    bool m_OnlyFilteredObjects = false;

    void Describe(Inspector& inspector);
};

/// Lines where the brightness of the picture changes, whatever makes it change: silhouettes,
/// textures, shadows.
/// @source technique 3 of the introduction of the article on selection outlines
class ColorEdgesRendererFeature final
    : public OutlineRendererFeature<ColorEdges, ColorEdgesSettings, ColorEdgesPass>
{
public:
    explicit ColorEdgesRendererFeature(ColorEdgesSettings settings = {})
        : OutlineRendererFeature(settings)
    {
        name = "ColorEdgesRendererFeature";
    }
};

} // namespace limn
