#pragma once

#include "device/UniqueHandle.h"
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

} // namespace limn::vulkan
