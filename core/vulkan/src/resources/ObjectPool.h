#pragma once

#include "memory/UploadCommands.h"
#include "resources/Pooled.h"
#include <limn/core/FrameCommands.h>

namespace limn::vulkan
{

/// The buffer behind one InstanceData. It has a PerDrawData for each object.
struct PooledObjects
{
    static constexpr std::uint64_t k_Unknown = ~std::uint64_t{0};

    std::weak_ptr<const InstanceData> owner;
    Buffer buffer;
    std::uint64_t version = k_Unknown; ///< the version of the table that the buffer holds
    std::uint64_t createdBy = 0;
    std::uint64_t lastUse = 0;
};

/// All object buffers, found by their table; made and freed like the images of ImagePool. Only data
/// that have changed since the last frame are copied.
class ObjectPool
{
public:
    ObjectPool(VkDevice device, MemoryAllocator& allocator)
        : m_Device(device), m_Allocator(allocator)
    {
    }

    /// Returns the table's buffer with its present data, and records the copies.
    VkBuffer Update(const std::shared_ptr<const InstanceData>& table, std::uint64_t number,
                    UploadCommands& uploads);
    void Rollback(std::uint64_t number) noexcept;
    void Sweep(std::uint64_t finished);

private:
    PooledObjects& Use(const std::shared_ptr<const InstanceData>& table, std::uint64_t number);

    VkDevice m_Device;
    MemoryAllocator& m_Allocator;
    std::unordered_map<std::uint64_t, PooledObjects> m_Objects; ///< by InstanceData::id
    std::vector<PooledObjects> m_Outgrown;                      ///< the GPU may still use them
    std::vector<VkBufferCopy> m_Regions; ///< the regions of the copies that are being recorded
};

} // namespace limn::vulkan
