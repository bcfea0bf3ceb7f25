#pragma once

#include "memory/MemoryAllocator.h"
#include <span>

namespace limn::vulkan
{

/// The place of uploaded bytes that the GPU reads during one frame.
struct UploadedBytes
{
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize offset = 0;
    std::byte* mapped = nullptr;
};

/// The upload memory of one frame. It grows by chunks; all of it is freed at once.
class LinearMemory
{
public:
    /// @param use  Upload or Staging
    LinearMemory(VkDevice device, MemoryAllocator& allocator, MemoryUse use);

    /// Returns room for `size` bytes at a multiple of k_UniformAlignment. It lives until Reset().
    UploadedBytes Allocate(VkDeviceSize size);
    UploadedBytes Upload(std::span<const std::byte> bytes);

    /// Forgets everything. Keeps one chunk that is large enough for what both of the last two
    /// frames needed.
    void Reset();

private:
    VkDeviceSize ChunkSize() const;

    VkDevice m_Device;
    MemoryAllocator* m_Allocator;
    MemoryUse m_Use;
    std::vector<Buffer> m_Chunks;
    VkDeviceSize m_Used = 0;     ///< used bytes of the last chunk
    VkDeviceSize m_Before = 0;   ///< used bytes of the chunks before it
    VkDeviceSize m_Previous = 0; ///< bytes used by the frame before
    VkDeviceSize m_Last = 0;     ///< bytes used by each of the two frames before
};

} // namespace limn::vulkan
