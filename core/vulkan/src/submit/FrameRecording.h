#pragma once

#include "descriptors/FrameData.h"
#include "submit/DeviceResources.h"

namespace limn::vulkan
{

/// The objects on which the recorded commands of a frame depend. As long as they are unchanged, the
/// commands may be submitted again for a frame of the same structure.
struct FrameRecording
{
    struct UsedImage
    {
        PooledImage* image = nullptr;
        ImageUse before;
        ImageUse after;
    };

    std::uint64_t structure = 0;      ///< CompiledFrame::structure; 0 = not to be submitted again
    std::uint64_t changes = 0;        ///< DeviceResources::changeCount, for all following members
    std::vector<UsedImage> images;    ///< all images of the frame
    std::vector<std::uint64_t*> uses; ///< `lastUse` of its meshes, programs, samplers
    std::vector<std::weak_ptr<const GraphicsBuffer>> buffers;
    std::optional<FrameData> data;
    VkBuffer objects = VK_NULL_HANDLE; ///< null = no draw has any
    std::uint32_t objectCount = 0;

    /// Records the objects that the frame used.
    /// @param number  the number of its submission
    void Take(DeviceResources& resources, std::uint64_t number);
    /// Returns whether all of these objects are unchanged.
    bool isValid(const CompiledFrame& frame, std::uint64_t changeCount) const;
    /// Marks all of them as used by submission `number`, too.
    void Use(std::uint64_t number) const;
};

} // namespace limn::vulkan
