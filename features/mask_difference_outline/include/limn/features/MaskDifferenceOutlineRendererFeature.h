#pragma once

#include <limn/features/MaskDifferenceOutlinePass.h>
#include <limn/features/MaskValue.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

/// When, around which objects and how lines are drawn.
struct MaskDifferenceOutlineSettings : OutlineSettings
{
    /// Where objects that touch each other have a line between them.
    OutlineGrouping m_Grouping = OutlineGrouping::PerObject;
    /// Each group has a colour of its own, ColorOfGroup, in place of the component's.
    bool m_ColorByGroup = false;
    /// Adds the line in place, as a device with framebuffer fetch would; without it, the picture is
    /// copied and read as a texture. Both give the same picture.
    bool m_FramebufferFetch = true;

    void Describe(Inspector& inspector);
};

/// Lines around objects by comparing a mask of them with its four neighbours, up to a depth.
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
