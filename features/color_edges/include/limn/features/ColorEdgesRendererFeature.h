#pragma once

#include <limn/features/ColorEdgesPass.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

/// The settings for when and where the lines are drawn.
struct ColorEdgesSettings : OutlineSettings
{
    /// Draws lines only where a filtered object is seen. If false, draws them all over the picture,
    /// whatever the filter.
    bool m_OnlyFilteredObjects = false;

    void Describe(Inspector& inspector);
};

/// Draws lines where the brightness of the picture changes, whatever the cause: silhouettes,
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
