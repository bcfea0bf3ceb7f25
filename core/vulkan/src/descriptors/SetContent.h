#pragma once

#include <cstdint>
#include <vector>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

/// What a descriptor set holds: one descriptor a binding. Reused, it allocates nothing.
class SetContent
{
public:
    void Clear(VkDescriptorSetLayout layout);
    void AddBuffer(std::uint32_t binding, VkDescriptorType type,
                   const VkDescriptorBufferInfo& buffer);
    void AddImage(std::uint32_t binding, VkDescriptorType type, const VkDescriptorImageInfo& image);

    VkDescriptorSetLayout layout() const { return m_Layout; }
    void WriteTo(VkDevice device, VkDescriptorSet set);

    /// Equal where layout and all descriptors are.
    const std::vector<std::uint64_t>& key() const { return m_Key; }

private:
    void Add(std::uint32_t binding, VkDescriptorType type);

    VkDescriptorSetLayout m_Layout = VK_NULL_HANDLE;
    std::vector<std::uint64_t> m_Key;
    std::vector<VkWriteDescriptorSet> m_Writes;
    std::vector<VkDescriptorBufferInfo> m_Buffers; ///< of the writes of buffers, in their order
    std::vector<VkDescriptorImageInfo> m_Images;   ///< likewise
};

} // namespace limn::vulkan
