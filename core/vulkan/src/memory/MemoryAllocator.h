#pragma once

#include "device/UniqueHandle.h"
#include "memory/RangeAllocator.h"
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace limn::vulkan
{

enum class MemoryUse
{
    Gpu,
    Transient, ///< attachments that a device with tiles may never write out
    Upload,    ///< written by the CPU, mapped, read by shaders
    Staging,   ///< likewise, copied from only
    ReadBack   ///< read by the CPU, mapped
};

/// Buffers and images live in blocks of their own, which satisfies bufferImageGranularity.
enum class MemoryContent
{
    Buffers,
    Images
};

class MemoryAllocator;

/// A piece of device memory, returned on destruction; must not outlive its allocator.
class MemoryAllocation
{
public:
    MemoryAllocation() = default;
    MemoryAllocation(MemoryAllocation&& other) noexcept { Swap(other); }
    MemoryAllocation& operator=(MemoryAllocation&& other) noexcept
    {
        Swap(other);
        return *this;
    }
    ~MemoryAllocation();

    VkDeviceMemory memory() const;
    VkDeviceSize offset() const { return m_Offset; }
    std::byte* mapped() const; ///< null where the CPU has no access

private:
    friend class MemoryAllocator;
    struct Block;
    void Swap(MemoryAllocation& other) noexcept;

    MemoryAllocator* m_Allocator = nullptr;
    Block* m_Block = nullptr;
    VkDeviceSize m_Offset = 0;
    VkDeviceSize m_Size = 0;
};

/// Sub-allocates from large blocks, since a driver may allow as few as 4096 allocations. A block
/// that has become empty is kept for some frames: what is made and dropped in every frame, as a
/// read-back, costs the driver nothing.
class MemoryAllocator
{
public:
    MemoryAllocator(VkDevice device, VkPhysicalDevice physicalDevice);
    ~MemoryAllocator();
    MemoryAllocator(const MemoryAllocator&) = delete;
    MemoryAllocator& operator=(const MemoryAllocator&) = delete;

    /// Takes what fits best of the device's kinds of memory, and the next where its heap is full.
    /// @param name  of the resource, for the error
    /// @throws VulkanError if every heap that would do is full
    MemoryAllocation Allocate(const VkMemoryRequirements& needs, MemoryUse use,
                              MemoryContent content, const std::string& name);

    /// A frame begins: frees the blocks that have been empty for long.
    void Sweep();

    VkDeviceSize allocatedBytes() const; ///< taken from the driver
    VkDeviceSize usedBytes() const;      ///< of these, handed out
    /// How many allocations have come back, with their resource gone; not those of
    /// staging and read-backs, which no shader sees.
    std::uint64_t returnedCount() const { return m_Returned; }

private:
    friend class MemoryAllocation;
    using Block = MemoryAllocation::Block;

    std::vector<std::uint32_t> MemoryTypes(std::uint32_t allowed, MemoryUse use) const;
    /// Null where the heap is full.
    UniqueMemory TryAllocate(VkDeviceSize size, std::uint32_t type, const std::string& name);
    Block& NewBlock(UniqueMemory memory, VkDeviceSize size, std::uint32_t type, MemoryUse use,
                    MemoryContent content, const std::string& name);
    void Return(Block& block, VkDeviceSize offset, VkDeviceSize size) noexcept;

    VkDevice m_Device;
    VkPhysicalDeviceMemoryProperties m_Properties{};
    std::vector<std::unique_ptr<Block>> m_Blocks;
    std::uint64_t m_Returned = 0;
};

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
