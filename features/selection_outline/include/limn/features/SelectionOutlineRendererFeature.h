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

    /// Sets the time since which an object is selected, and everything below it that has no time of
    /// its own. The colour starts over at that time.
    /// @param object   must not be destroyed before ClearStartTimes
    /// @param seconds  the time on the clock of RenderRequest::time
    /// @throws ContractError if `seconds` is not finite
    void SetStartTime(const GameObject& object, double seconds);
    void ClearStartTimes();

    /// Returns 0, because objects outside of the picture are not in the blurred texture, either.
    float cullingMargin(const VolumeStackPointer&) const override { return 0.0f; }
};

} // namespace limn
