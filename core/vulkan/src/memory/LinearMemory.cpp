#include "memory/LinearMemory.h"

#include <algorithm>
#include <cstring>
#include <limn/core/FrameCommands.h>

namespace limn::vulkan
{

namespace
{

/// Of uniform and storage buffers; Vulkan lets a device ask no more of either.
constexpr VkDeviceSize k_Alignment = k_UniformAlignment;
constexpr VkDeviceSize k_ChunkBytes = VkDeviceSize{1} << 20;
constexpr VkBufferUsageFlags k_Usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                                       VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                                       VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

} // namespace

LinearMemory::LinearMemory(VkDevice device, MemoryAllocator& allocator)
    : m_Device(device), m_Allocator(&allocator)
{
}

UploadedBytes LinearMemory::Allocate(VkDeviceSize size)
{
    if (m_Chunks.empty() || m_Used + size > m_Chunks.back().size)
    {
        m_Chunks.emplace_back(m_Device, *m_Allocator, std::max(size, k_ChunkBytes), k_Usage,
                              MemoryUse::Upload, "frame upload memory");
        m_Used = 0;
    }
    const Buffer& chunk = m_Chunks.back();
    const UploadedBytes result{chunk.handle.get(), m_Used, chunk.memory.mapped() + m_Used};
    m_Used = (m_Used + size + k_Alignment - 1) & ~(k_Alignment - 1);
    return result;
}

UploadedBytes LinearMemory::Upload(std::span<const std::byte> bytes)
{
    const UploadedBytes result = Allocate(bytes.size());
    std::memcpy(result.mapped, bytes.data(), bytes.size());
    return result;
}

void LinearMemory::Reset()
{
    const auto keep = std::find_if(m_Chunks.begin(), m_Chunks.end(),
                                   [](const Buffer& chunk) { return chunk.size == k_ChunkBytes; });
    if (keep != m_Chunks.end())
    {
        std::iter_swap(m_Chunks.begin(), keep);
        m_Chunks.erase(m_Chunks.begin() + 1, m_Chunks.end());
    }
    else
    {
        m_Chunks.clear();
    }
    m_Used = 0;
}

} // namespace limn::vulkan
