#pragma once

#include "descriptors/FrameData.h"
#include "submit/DeviceResources.h"

namespace limn::vulkan
{

/// What the recorded commands of a frame rely on: as long as that is as it was, they may be
/// submitted again for a frame of the same structure.
struct FrameRecording
{
    struct UsedImage
    {
        PooledImage* image = nullptr;
        ImageUse before;
        ImageUse after;
    };

    std::uint64_t structure = 0;      ///< CompiledFrame::structure; 0 = not to be submitted again
    std::uint64_t changes = 0;        ///< DeviceResources::changeCount, of all that follows
    std::vector<UsedImage> images;    ///< all of the frame
    std::vector<std::uint64_t*> uses; ///< `lastUse` of its meshes, programs, samplers
    std::vector<std::weak_ptr<const GraphicsBuffer>> buffers;
    std::optional<FrameData> data;
    VkBuffer objects = VK_NULL_HANDLE; ///< null = no draw has any
    std::uint32_t objectCount = 0;

    /// Notes what the frame used. @param number  of its submission
    void Take(DeviceResources& resources, std::uint64_t number);
    /// Whether all is as it was.
    bool isValid(const CompiledFrame& frame, std::uint64_t changeCount) const;
    /// All of it is used by submission `number`, too.
    void Use(std::uint64_t number) const;
};

} // namespace limn::vulkan
