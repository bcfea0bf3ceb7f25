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
    /// @param use  Upload or Staging
    LinearMemory(VkDevice device, MemoryAllocator& allocator, MemoryUse use);

    /// Room for `size` bytes, at a multiple of k_UniformAlignment; lives until Reset().
    UploadedBytes Allocate(VkDeviceSize size);
    UploadedBytes Upload(std::span<const std::byte> bytes);

    /// Forgets everything; keeps one chunk that holds what both of the last two frames needed.
    void Reset();

private:
    VkDeviceSize ChunkSize() const;

    VkDevice m_Device;
    MemoryAllocator* m_Allocator;
    MemoryUse m_Use;
    std::vector<Buffer> m_Chunks;
    VkDeviceSize m_Used = 0;     ///< of the last chunk
    VkDeviceSize m_Before = 0;   ///< of the chunks before it
    VkDeviceSize m_Previous = 0; ///< by the frame before
    VkDeviceSize m_Last = 0;     ///< by each of the two frames before
};

} // namespace limn::vulkan
