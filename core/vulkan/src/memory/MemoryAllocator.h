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
    Staging,   ///< likewise, but only copied from
    ReadBack   ///< read by the CPU, mapped
};

/// The content of a block. Buffers and images have separate blocks, which satisfies
/// bufferImageGranularity.
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
    std::byte* mapped() const; ///< null if the CPU has no access

private:
    friend class MemoryAllocator;
    struct Block;
    void Swap(MemoryAllocation& other) noexcept;

    MemoryAllocator* m_Allocator = nullptr;
    Block* m_Block = nullptr;
    VkDeviceSize m_Offset = 0;
    VkDeviceSize m_Size = 0;
};

/// Sub-allocates from large blocks, because a driver may allow as few as 4096 allocations. An empty
/// block is kept for some frames, so that resources made and dropped in every frame, for example
/// for a read-back, cost no calls of the driver.
class MemoryAllocator
{
public:
    MemoryAllocator(VkDevice device, VkPhysicalDevice physicalDevice);
    ~MemoryAllocator();
    MemoryAllocator(const MemoryAllocator&) = delete;
    MemoryAllocator& operator=(const MemoryAllocator&) = delete;

    /// Allocates from the device's memory type that fits best, and from the next if its heap is
    /// full.
    /// @param name  the name of the resource, for the error
    /// @throws VulkanError if every suitable heap is full
    MemoryAllocation Allocate(const VkMemoryRequirements& needs, MemoryUse use,
                              MemoryContent content, const std::string& name);

    /// Must be called when a frame begins. Frees the blocks that have been empty for long.
    void Sweep();

    VkDeviceSize allocatedBytes() const; ///< taken from the driver
    VkDeviceSize usedBytes() const;      ///< the part of these that is allocated
    /// Returns how many allocations have been returned because their resource is gone. Does not
    /// count those of staging and read-backs, which no shader sees.
    std::uint64_t returnedCount() const { return m_Returned; }

private:
    friend class MemoryAllocation;
    using Block = MemoryAllocation::Block;

    std::vector<std::uint32_t> MemoryTypes(std::uint32_t allowed, MemoryUse use) const;
    /// Returns null if the heap is full.
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
    MemoryAllocation memory; ///< freed after the handle
    UniqueBuffer handle;
    VkDeviceSize size = 0;

    Buffer() = default;
    Buffer(VkDevice device, MemoryAllocator& allocator, VkDeviceSize bytes,
           VkBufferUsageFlags usage, MemoryUse use, const std::string& name);
};

} // namespace limn::vulkan
