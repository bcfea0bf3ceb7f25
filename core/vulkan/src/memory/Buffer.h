#pragma once

#include "memory/MemoryAllocator.h"

namespace limn::vulkan
{

/// A buffer with its memory.
struct Buffer
{
    MemoryAllocation memory; ///< goes after the handle
    UniqueBuffer handle;
    VkDeviceSize size = 0;

    Buffer() = default;
    Buffer(VkDevice device, MemoryAllocator& allocator, VkDeviceSize bytes,
           VkBufferUsageFlags usage, MemoryUse use, const std::string& name);
};

} // namespace limn::vulkan
