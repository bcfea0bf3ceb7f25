#include "resources/BufferPool.h"

#include "device/Translate.h"
#include <algorithm>

namespace limn::vulkan
{

namespace
{

constexpr VkPipelineStageFlags2 k_CopyStages = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
constexpr VkAccessFlags2 k_ShaderAccess =
    VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT |
    VK_ACCESS_2_UNIFORM_READ_BIT | VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT;

void RecordBetween(VkCommandBuffer commands, const UsageScope& from, const UsageScope& to)
{
    VkMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    barrier.srcStageMask = from.stages;
    barrier.srcAccessMask = from.access;
    barrier.dstStageMask = to.stages;
    barrier.dstAccessMask = to.access;
    RecordBarrier(commands, barrier);
}

const UsageScope k_Copied{VK_IMAGE_LAYOUT_UNDEFINED, k_CopyStages, VK_ACCESS_2_TRANSFER_WRITE_BIT};

UsageScope ShaderScope()
{
    return {VK_IMAGE_LAYOUT_UNDEFINED,
            ToPipelineStages(ShaderStage::None) | VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT |
                k_CopyStages,
            k_ShaderAccess | VK_ACCESS_2_TRANSFER_WRITE_BIT};
}

/// Records the changes after `version`, the oldest first, because a later one may overlap an
/// earlier one.
void RecordChanges(const GraphicsBuffer& buffer, std::uint64_t version, VkBuffer target,
                   UploadCommands& uploads)
{
    for (const GraphicsBuffer::Change& change : buffer.changes())
    {
        if (change.version <= version)
        {
            continue;
        }
        VkCommandBuffer commands = uploads.commands();
        RecordBetween(commands, ShaderScope(), k_Copied);
        const UploadedBytes bytes =
            uploads.staging().Upload(buffer.bytes().subspan(change.offset, change.size));
        const VkBufferCopy region{bytes.offset, change.offset, change.size};
        vkCmdCopyBuffer(commands, bytes.buffer, target, 1, &region);
        RecordBetween(commands, k_Copied, ShaderScope());
    }
}

} // namespace

PooledBuffer& BufferPool::Use(const std::shared_ptr<const GraphicsBuffer>& buffer,
                              std::uint64_t number, UploadCommands& uploads)
{
    const auto found = m_Buffers.find(buffer->id());
    PooledBuffer& pooled = found != m_Buffers.end() ? found->second : Add(buffer, number, uploads);
    if (pooled.lastUse != number)
    {
        pooled.lastUse = number;
        pooled.before = pooled.version;
    }
    if (pooled.version != buffer->version())
    {
        RecordChanges(*buffer, pooled.version, pooled.buffer.handle.get(), uploads);
        pooled.version = buffer->version();
    }
    return pooled;
}

PooledBuffer& BufferPool::Add(const std::shared_ptr<const GraphicsBuffer>& buffer,
                              std::uint64_t number, UploadCommands& uploads)
{
    const VkDeviceSize size = buffer->bytes().size();
    if (size > m_Limits.maxStorageBufferRange)
    {
        throw ContractError("buffer '" + buffer->name() + "' has " + std::to_string(size) +
                            " bytes; the device binds at most " +
                            std::to_string(m_Limits.maxStorageBufferRange));
    }
    PooledBuffer pooled;
    pooled.owner = buffer;
    pooled.createdBy = number;
    pooled.buffer = Buffer{m_Device,
                           m_Allocator,
                           (size + 3) / 4 * 4, // of so many bytes vkCmdFillBuffer fills a multiple
                           VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                               VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
                               VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                           MemoryUse::Gpu,
                           buffer->name()};
    vkCmdFillBuffer(uploads.commands(), pooled.buffer.handle.get(), 0, VK_WHOLE_SIZE, 0);
    RecordBetween(uploads.commands(), k_Copied, ShaderScope());
    return m_Buffers.emplace(buffer->id(), std::move(pooled)).first->second;
}

PooledBuffer* BufferPool::Find(const GraphicsBuffer& buffer)
{
    const auto found = m_Buffers.find(buffer.id());
    return found == m_Buffers.end() ? nullptr : &found->second;
}

const PooledBuffer* BufferPool::Find(const GraphicsBuffer& buffer) const
{
    const auto found = m_Buffers.find(buffer.id());
    return found == m_Buffers.end() ? nullptr : &found->second;
}

void BufferPool::AddUsed(std::uint64_t number,
                         std::vector<std::weak_ptr<const GraphicsBuffer>>& used) const
{
    for (const auto& [id, pooled] : m_Buffers)
    {
        if (!pooled.owner.expired() && pooled.lastUse == number)
        {
            used.push_back(pooled.owner);
        }
    }
}

void BufferPool::Rollback(std::uint64_t number) noexcept
{
    std::erase_if(m_Buffers, [&](const auto& entry) { return entry.second.createdBy == number; });
    for (auto& [id, pooled] : m_Buffers)
    {
        if (pooled.lastUse == number)
        {
            pooled.version = pooled.before; // the copies were never made
            pooled.lastUse = number - 1;
        }
    }
}

void BufferPool::Sweep(std::uint64_t finished)
{
    std::erase_if(m_Buffers, [&](const auto& entry)
                  { return entry.second.owner.expired() && entry.second.lastUse <= finished; });
}

} // namespace limn::vulkan
