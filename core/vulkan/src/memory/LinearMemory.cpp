#include "memory/LinearMemory.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limn/core/FrameCommands.h>

namespace limn::vulkan
{

namespace
{

/// The alignment of uniform and storage buffers. Vulkan does not let a device require a greater one
/// for either.
constexpr VkDeviceSize k_Alignment = k_UniformAlignment;
constexpr VkDeviceSize k_ChunkBytes = VkDeviceSize{1} << 20;
constexpr VkBufferUsageFlags k_Usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                                       VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                                       VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

} // namespace

LinearMemory::LinearMemory(VkDevice device, MemoryAllocator& allocator, MemoryUse use)
    : m_Device(device), m_Allocator(&allocator), m_Use(use)
{
}

UploadedBytes LinearMemory::Allocate(VkDeviceSize size)
{
    if (m_Chunks.empty() || m_Used + size > m_Chunks.back().size)
    {
        m_Before += m_Used;
        m_Used = 0;
        m_Chunks.emplace_back(m_Device, *m_Allocator, std::max(size, ChunkSize()), k_Usage, m_Use,
                              "frame upload memory");
    }
    const Buffer& chunk = m_Chunks.back();
    const UploadedBytes result{chunk.handle.get(), m_Used, chunk.memory.mapped() + m_Used};
    m_Used = (m_Used + size + k_Alignment - 1) & ~(k_Alignment - 1);
    return result;
}

/// Returns the size of a new chunk. It holds all that the frame before needed.
VkDeviceSize LinearMemory::ChunkSize() const
{
    return std::max(k_ChunkBytes, std::bit_ceil(m_Last));
}

UploadedBytes LinearMemory::Upload(std::span<const std::byte> bytes)
{
    const UploadedBytes result = Allocate(bytes.size());
    std::memcpy(result.mapped, bytes.data(), bytes.size());
    return result;
}

void LinearMemory::Reset()
{
    // Memory that a single frame needs, for example for uploads, is not kept for later frames.
    const VkDeviceSize used = m_Before + m_Used;
    m_Last = std::min(used, m_Previous);
    m_Previous = used;
    if (m_Chunks.size() != 1 || m_Chunks.front().size != ChunkSize())
    {
        m_Chunks.clear();
    }
    m_Before = 0;
    m_Used = 0;
}

} // namespace limn::vulkan
