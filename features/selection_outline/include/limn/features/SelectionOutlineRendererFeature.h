#pragma once

#include <limn/features/OutlineEffect.h>
#include <limn/features/OutlineRendererFeature.h>
#include <limn/features/SelectionOutline.h>

namespace limn
{

/// Outlines selected objects by drawing them into a texture, blurring that outwards, and laying it
/// over the picture.
/// @source the article on outlines of selected objects (Unity): OutlineEffect, OutlineObject
class SelectionOutlineRendererFeature final
    : public OutlineRendererFeature<SelectionOutline, SelectionOutlineSettings, OutlineEffect>
{
public:
    using OutlineRendererFeature::OutlineRendererFeature;

    /// Since when an object is selected, and all below it that has no time of its own: the colour
    /// starts over there.
    /// @param object   until ClearStartTimes it must not be destroyed
    /// @param seconds  on the clock of RenderRequest::time
    /// @throws ContractError if `seconds` is not finite
    void SetStartTime(const GameObject& object, double seconds);
    void ClearStartTimes();

    /// 0: what is not in the picture is not in the texture that is blurred, either.
    float cullingMargin(const VolumeStackPointer&) const override { return 0.0f; }
};

} // namespace limn
