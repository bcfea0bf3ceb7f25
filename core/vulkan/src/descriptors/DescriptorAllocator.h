#pragma once

#include "device/UniqueHandle.h"
#include <vector>

namespace limn::vulkan
{

/// Descriptor sets of one frame: grows by pools, given back all at once.
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
