#include "descriptors/DescriptorCache.h"

#include <array>
#include <limn/base/HashContent.h>

namespace limn::vulkan
{

namespace
{

constexpr std::uint32_t k_SetsPerPool = 512;

VkResult TryAllocate(VkDevice device, VkDescriptorPool pool, VkDescriptorSetLayout layout,
                     VkDescriptorSet& set)
{
    auto info = Make<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
    info.descriptorPool = pool;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &layout;
    return vkAllocateDescriptorSets(device, &info, &set);
}

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

VkDescriptorSet DescriptorAllocator::Allocate(VkDescriptorSetLayout layout)
{
    VkDescriptorSet set = VK_NULL_HANDLE;
    for (; m_Current < m_Pools.size(); ++m_Current)
    {
        const VkResult result = TryAllocate(m_Device, m_Pools[m_Current].get(), layout, set);
        if (result == VK_SUCCESS)
        {
            return set;
        }
        if (result != VK_ERROR_OUT_OF_POOL_MEMORY && result != VK_ERROR_FRAGMENTED_POOL)
        {
            Check(result, "vkAllocateDescriptorSets");
        }
    }
    AddPool();
    Check(TryAllocate(m_Device, m_Pools[m_Current].get(), layout, set), "vkAllocateDescriptorSets");
    return set;
}

void DescriptorAllocator::Reset()
{
    for (const UniqueDescriptorPool& pool : m_Pools)
    {
        Check(vkResetDescriptorPool(m_Device, pool.get(), 0), "vkResetDescriptorPool");
    }
    m_Current = 0;
}

void DescriptorAllocator::AddPool()
{
    // A share of each kind that a pass of many textures still fits into.
    constexpr std::array<VkDescriptorPoolSize, 6> sizes = {{
        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 4 * k_SetsPerPool},
        {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, 4 * k_SetsPerPool},
        {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 4 * k_SetsPerPool},
        {VK_DESCRIPTOR_TYPE_SAMPLER, 4 * k_SetsPerPool},
        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, k_SetsPerPool},
        {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, k_SetsPerPool},
    }};
    auto info = Make<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    info.maxSets = k_SetsPerPool;
    info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    info.pPoolSizes = sizes.data();
    m_Pools.emplace_back(m_Device, vkCreateDescriptorPool, info, "vkCreateDescriptorPool");
}

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
    auto write = Make<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
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

std::size_t DescriptorCache::Hash::operator()(const std::vector<std::uint64_t>& key) const
{
    return HashContent({reinterpret_cast<const char*>(key.data()), key.size() * sizeof(key[0])});
}

void DescriptorCache::Begin(std::uint64_t destroyed)
{
    constexpr std::size_t k_Spare = 64;
    if (destroyed != m_Destroyed || m_Sets.size() > 2 * m_Used + k_Spare)
    {
        m_Sets.clear();
        m_Allocator.Reset();
        m_Destroyed = destroyed;
    }
    ++m_Frame;
    m_Used = 0;
}

VkDescriptorSet DescriptorCache::Get(SetContent& content)
{
    const auto found = m_Sets.find(content.key());
    Entry& entry = found != m_Sets.end() ? found->second : m_Sets[content.key()];
    if (entry.set == VK_NULL_HANDLE)
    {
        entry.set = m_Allocator.Allocate(content.layout());
        content.WriteTo(m_Device, entry.set);
        ++m_WriteCount;
    }
    m_Used += entry.frame != m_Frame ? 1 : 0;
    entry.frame = m_Frame;
    return entry.set;
}

} // namespace limn::vulkan
