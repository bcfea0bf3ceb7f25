#pragma once

#include "memory/UploadCommands.h"
#include <limn/core/FrameCommands.h>
#include <unordered_map>

namespace limn::vulkan
{

/// The buffer behind one InstanceData: a PerDrawData for each object.
struct PooledObjects
{
    static constexpr std::uint64_t k_Unknown = ~std::uint64_t{0};

    std::weak_ptr<const InstanceData> owner;
    Buffer buffer;
    std::uint64_t version = k_Unknown; ///< of the table that the buffer holds
    std::uint64_t createdBy = 0;
    std::uint64_t lastUse = 0;
};

/// All object buffers, found by their table; made and freed as ImagePool does. Only what has
/// changed since the last frame is copied.
class ObjectPool
{
public:
    ObjectPool(VkDevice device, MemoryAllocator& allocator)
        : m_Device(device), m_Allocator(allocator)
    {
    }

    /// The table's buffer with what it holds now: records the copies.
    VkBuffer Update(const std::shared_ptr<const InstanceData>& table, std::uint64_t number,
                    UploadCommands& uploads);
    void Rollback(std::uint64_t number) noexcept;
    void Sweep(std::uint64_t finished);

private:
    PooledObjects& Use(const std::shared_ptr<const InstanceData>& table, std::uint64_t number);

    VkDevice m_Device;
    MemoryAllocator& m_Allocator;
    std::unordered_map<std::uint64_t, PooledObjects> m_Objects; ///< by InstanceData::id
    std::vector<PooledObjects> m_Outgrown;                      ///< may be in use by the GPU still
    std::vector<VkBufferCopy> m_Regions; ///< of the copies that are being recorded
};

} // namespace limn::vulkan
