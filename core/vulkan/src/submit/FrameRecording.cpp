#include "submit/FrameRecording.h"

#include <algorithm>

namespace limn::vulkan
{

void FrameRecording::Take(DeviceResources& resources, std::uint64_t number)
{
    changes = resources.changeCount();
    images.clear();
    resources.images.ForEachUsed(number,
                                 [&](PooledImage& image) {
                                     images.push_back({&image, image.submitted, image.use});
                                 });
    buffers.clear();
    resources.buffers.AddUsed(number, buffers);
    uses.clear();
    resources.meshes.AddUses(number, uses);
    resources.programs.AddUses(number, uses);
    resources.samplers.AddUses(number, uses);
}

bool FrameRecording::isValid(const CompiledFrame& frame, std::uint64_t changeCount) const
{
    return structure != 0 && structure == frame.structure && changes == changeCount && data &&
           data->Fits(frame) &&
           (objects == VK_NULL_HANDLE ||
            (frame.objects && frame.objects->count() == objectCount)) &&
           std::ranges::all_of(images, [](const UsedImage& used)
                               { return used.image->submitted == used.before; });
}

void FrameRecording::Use(std::uint64_t number) const
{
    for (const UsedImage& used : images)
    {
        used.image->lastUse = number;
        used.image->use = used.after;
    }
    for (std::uint64_t* use : uses)
    {
        *use = number;
    }
}

} // namespace limn::vulkan
