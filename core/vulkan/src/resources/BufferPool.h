#pragma once

#include "memory/UploadCommands.h"
#include "resources/Pooled.h"
#include <limn/core/GraphicsBuffer.h>

namespace limn::vulkan
{

/// The buffer behind one GraphicsBuffer.
struct PooledBuffer
{
    std::weak_ptr<const GraphicsBuffer> owner;
    Buffer buffer;
    /// The version of the data in it, including the uploads prepared so far.
    std::uint64_t version = 0;
    std::uint64_t before = 0; ///< the version before submission `lastUse`
    std::uint64_t createdBy = 0;
    std::uint64_t lastUse = 0;
};

/// All buffers that shaders share with the CPU, found by their GraphicsBuffer; made and freed like
/// the images of ImagePool. Data that kernels wrote stay where nothing was set since.
class BufferPool
{
public:
    BufferPool(VkDevice device, MemoryAllocator& allocator, const VkPhysicalDeviceLimits& limits)
        : m_Device(device), m_Allocator(allocator), m_Limits(limits)
    {
    }

    /// Returns the buffer with the data set until now, and records the copies.
    /// @throws ContractError if it is larger than the device can bind
    PooledBuffer& Use(const std::shared_ptr<const GraphicsBuffer>& buffer, std::uint64_t number,
                      UploadCommands& uploads);
    /// Returns the buffer, or null if no frame has used it.
    PooledBuffer* Find(const GraphicsBuffer& buffer) { return FindPooled(m_Buffers, buffer.id()); }
    /// Adds the buffers that submission `number` uses.
    void AddUsed(std::uint64_t number,
                 std::vector<std::weak_ptr<const GraphicsBuffer>>& used) const;
    void Rollback(std::uint64_t number) noexcept;
    void Sweep(std::uint64_t finished) { SweepPooled(m_Buffers, finished); }

private:
    PooledBuffer& Add(const std::shared_ptr<const GraphicsBuffer>& buffer, std::uint64_t number,
                      UploadCommands& uploads);

    VkDevice m_Device;
    MemoryAllocator& m_Allocator;
    const VkPhysicalDeviceLimits& m_Limits;
    std::unordered_map<std::uint64_t, PooledBuffer> m_Buffers; ///< by GraphicsBuffer::id
};

} // namespace limn::vulkan
