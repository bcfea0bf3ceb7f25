#include "descriptors/SetContent.h"

namespace limn::vulkan
{

namespace
{

template <typename T>
std::uint64_t Number(T handle)
{
    return reinterpret_cast<std::uint64_t>(handle);
}

bool IsBuffer(VkDescriptorType type)
{
    return type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER || type == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

} // namespace

void SetContent::Clear(VkDescriptorSetLayout layout)
{
    m_Layout = layout;
    m_Key.assign(1, Number(layout));
    m_Writes.clear();
    m_Buffers.clear();
    m_Images.clear();
}

void SetContent::AddBuffer(std::uint32_t binding, VkDescriptorType type,
                           const VkDescriptorBufferInfo& buffer)
{
    Add(binding, type);
    m_Buffers.push_back(buffer);
    m_Key.insert(m_Key.end(), {Number(buffer.buffer), buffer.offset, buffer.range});
}

void SetContent::AddImage(std::uint32_t binding, VkDescriptorType type,
                          const VkDescriptorImageInfo& image)
{
    Add(binding, type);
    m_Images.push_back(image);
    m_Key.insert(m_Key.end(), {Number(image.sampler), Number(image.imageView),
                               static_cast<std::uint64_t>(image.imageLayout)});
}

void SetContent::Add(std::uint32_t binding, VkDescriptorType type)
{
    m_Key.push_back((std::uint64_t{binding} << 32U) | static_cast<std::uint32_t>(type));
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstBinding = binding;
    write.descriptorCount = 1;
    write.descriptorType = type;
    m_Writes.push_back(write);
}

void SetContent::WriteTo(VkDevice device, VkDescriptorSet set)
{
    std::size_t buffer = 0;
    std::size_t image = 0;
    for (VkWriteDescriptorSet& write : m_Writes)
    {
        write.dstSet = set;
        if (IsBuffer(write.descriptorType))
        {
            write.pBufferInfo = &m_Buffers[buffer++];
        }
        else
        {
            write.pImageInfo = &m_Images[image++];
        }
    }
    vkUpdateDescriptorSets(device, static_cast<std::uint32_t>(m_Writes.size()), m_Writes.data(), 0,
                           nullptr);
}

} // namespace limn::vulkan
