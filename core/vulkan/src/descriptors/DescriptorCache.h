#pragma once

#include "device/UniqueHandle.h"
#include <unordered_map>
#include <vector>

namespace limn::vulkan
{

/// Allocates the descriptor sets of one frame. It grows by pools; all sets are freed at once.
class DescriptorAllocator
{
public:
    explicit DescriptorAllocator(VkDevice device) : m_Device(device) {}

    VkDescriptorSet Allocate(VkDescriptorSetLayout layout);
    void Reset();

private:
    void AddPool();

    VkDevice m_Device;
    std::vector<UniqueDescriptorPool> m_Pools;
    std::size_t m_Current = 0;
};

/// The content of a descriptor set, one descriptor per binding. It allocates nothing when it is
/// reused.
class SetContent
{
public:
    void Clear(VkDescriptorSetLayout layout);
    void AddBuffer(std::uint32_t binding, VkDescriptorType type,
                   const VkDescriptorBufferInfo& buffer);
    void AddImage(std::uint32_t binding, VkDescriptorType type, const VkDescriptorImageInfo& image);

    VkDescriptorSetLayout layout() const { return m_Layout; }
    void WriteTo(VkDevice device, VkDescriptorSet set);

    /// Returns a key that is equal for contents with equal layout and descriptors.
    const std::vector<std::uint64_t>& key() const { return m_Key; }

private:
    void Add(std::uint32_t binding, VkDescriptorType type);

    VkDescriptorSetLayout m_Layout = VK_NULL_HANDLE;
    std::vector<std::uint64_t> m_Key;
    std::vector<VkWriteDescriptorSet> m_Writes;
    /// The descriptors of buffers, in the order of their writes.
    std::vector<VkDescriptorBufferInfo> m_Buffers;
    std::vector<VkDescriptorImageInfo> m_Images; ///< likewise
};

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
