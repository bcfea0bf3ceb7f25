#include "memory/Buffer.h"

#include "device/Check.h"

namespace limn::vulkan
{

Buffer::Buffer(VkDevice device, MemoryAllocator& allocator, VkDeviceSize bytes,
               VkBufferUsageFlags usage, MemoryUse use, const std::string& name)
    : size(bytes)
{
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = bytes;
    info.usage = usage;
    VkBuffer buffer = VK_NULL_HANDLE;
    Check(vkCreateBuffer(device, &info, nullptr, &buffer), "vkCreateBuffer", name);
    handle = UniqueBuffer{device, buffer};
    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(device, buffer, &needs);
    memory = allocator.Allocate(needs, use, MemoryContent::Buffers, name);
    Check(vkBindBufferMemory(device, buffer, memory.memory(), memory.offset()),
          "vkBindBufferMemory", name);
}

} // namespace limn::vulkan
