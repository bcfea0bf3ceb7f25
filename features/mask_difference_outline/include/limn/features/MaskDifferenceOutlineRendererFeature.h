#pragma once

#include <limn/features/MaskDifferenceOutlinePass.h>
#include <limn/features/MaskValue.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

/// The settings for when, around which objects and how lines are drawn.
struct MaskDifferenceOutlineSettings : OutlineSettings
{
    /// The grouping of objects; there is a line between objects of different groups that touch each
    /// other.
    OutlineGrouping m_Grouping = OutlineGrouping::PerObject;
    /// Gives each group a colour of its own, ColorOfGroup, in place of the component's.
    bool m_ColorByGroup = false;
    /// Adds the line in place, as a device with framebuffer fetch does. If false, the picture is
    /// copied and read as a texture. Both give the same picture.
    bool m_FramebufferFetch = true;

    void Describe(Inspector& inspector);
};

/// Draws lines around objects by comparing each texel of a mask with its four neighbours, up to a
/// depth.
/// @source the article on outlines as post-processing (mask, four neighbours, depth clip)
class MaskDifferenceOutlineRendererFeature final
    : public OutlineRendererFeature<MaskDifferenceOutline, MaskDifferenceOutlineSettings,
                                    MaskDifferenceOutlinePass>
{
public:
    explicit MaskDifferenceOutlineRendererFeature(MaskDifferenceOutlineSettings settings = {})
        : OutlineRendererFeature(settings)
    {
        name = "MaskDifferenceOutlineRendererFeature";
    }
};

} // namespace limn
