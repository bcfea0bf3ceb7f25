#pragma once

#include <cstdint>
#include <vector>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

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

} // namespace limn::vulkan
