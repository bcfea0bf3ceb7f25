#pragma once

#include "descriptors/DescriptorAllocator.h"
#include "descriptors/SetContent.h"
#include <unordered_map>

namespace limn::vulkan
{

/// The descriptor sets of one frame in flight. They stay from frame to frame: a set that an earlier
/// frame bound is neither allocated nor written again.
class DescriptorCache
{
public:
    explicit DescriptorCache(VkDevice device) : m_Device(device), m_Allocator(device) {}

    /// Begins a frame. Forgets all sets if an object that they may describe is gone, because its
    /// handle may be reused for another object, or if most of them have not been used lately.
    /// @param destroyed  the number of buffers, images and layouts destroyed so far
    /// @pre the device is done with the sets' last frame
    void Begin(std::uint64_t destroyed);

    VkDescriptorSet Get(SetContent& content);

    std::size_t size() const { return m_Sets.size(); }
    std::uint64_t writeCount() const { return m_WriteCount; } ///< since construction

private:
    struct Entry
    {
        VkDescriptorSet set = VK_NULL_HANDLE;
        std::uint64_t frame = 0; ///< the last frame that used it
    };
    struct Hash
    {
        std::size_t operator()(const std::vector<std::uint64_t>& key) const;
    };

    VkDevice m_Device;
    DescriptorAllocator m_Allocator;
    std::unordered_map<std::vector<std::uint64_t>, Entry, Hash> m_Sets; ///< by SetContent::key
    std::uint64_t m_Destroyed = 0;
    std::uint64_t m_Frame = 0;
    std::size_t m_Used = 0; ///< sets of this frame
    std::uint64_t m_WriteCount = 0;
};

} // namespace limn::vulkan
