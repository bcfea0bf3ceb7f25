#pragma once

#include "memory/MemoryAllocator.h"
#include <span>

namespace limn::vulkan
{

/// Where a run of bytes went that the GPU reads during one frame.
struct UploadedBytes
{
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize offset = 0;
    std::byte* mapped = nullptr;
};

/// Upload memory of one frame: grows by chunks, given back all at once.
class LinearMemory
{
public:
    LinearMemory(VkDevice device, MemoryAllocator& allocator);

    /// Room for `size` bytes, at a multiple of k_UniformAlignment; lives until Reset().
    UploadedBytes Allocate(VkDeviceSize size);
    UploadedBytes Upload(std::span<const std::byte> bytes);

    /// Forgets everything; keeps one chunk of the usual size for the next frame.
    void Reset();

private:
    VkDevice m_Device;
    MemoryAllocator* m_Allocator;
    std::vector<Buffer> m_Chunks;
    VkDeviceSize m_Used = 0; ///< of the last chunk
};

} // namespace limn::vulkan
