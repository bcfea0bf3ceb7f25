#include "descriptors/DescriptorAllocator.h"

#include "device/Check.h"
#include <array>

namespace limn::vulkan
{

namespace
{

constexpr std::uint32_t k_SetsPerPool = 512;

VkResult TryAllocate(VkDevice device, VkDescriptorPool pool, VkDescriptorSetLayout layout,
                     VkDescriptorSet& set)
{
    VkDescriptorSetAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = pool;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &layout;
    return vkAllocateDescriptorSets(device, &info, &set);
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
    VkDescriptorPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    info.maxSets = k_SetsPerPool;
    info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    info.pPoolSizes = sizes.data();
    VkDescriptorPool pool = VK_NULL_HANDLE;
    Check(vkCreateDescriptorPool(m_Device, &info, nullptr, &pool), "vkCreateDescriptorPool");
    m_Pools.emplace_back(m_Device, pool);
}

} // namespace limn::vulkan
