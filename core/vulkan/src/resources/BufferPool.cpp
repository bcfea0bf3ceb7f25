#include "resources/BufferPool.h"

namespace limn::vulkan
{

namespace
{

constexpr UsageScope k_Copied{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};

UsageScope ShaderScope()
{
    return {ToPipelineStages(ShaderStage::None) | VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT |
                k_Copied.stages,
            VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT |
                VK_ACCESS_2_UNIFORM_READ_BIT | VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT |
                k_Copied.access};
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
        RecordBarrier(commands, ShaderScope(), k_Copied);
        const UploadedBytes bytes =
            uploads.staging().Upload(buffer.bytes().subspan(change.offset, change.size));
        const VkBufferCopy region{bytes.offset, change.offset, change.size};
        vkCmdCopyBuffer(commands, bytes.buffer, target, 1, &region);
        RecordBarrier(commands, k_Copied, ShaderScope());
    }
}

} // namespace

PooledBuffer& BufferPool::Use(const std::shared_ptr<const GraphicsBuffer>& buffer,
                              std::uint64_t number, UploadCommands& uploads)
{
    PooledBuffer* found = Find(*buffer);
    PooledBuffer& pooled = found != nullptr ? *found : Add(buffer, number, uploads);
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
    RecordBarrier(uploads.commands(), k_Copied, ShaderScope());
    return m_Buffers.emplace(buffer->id(), std::move(pooled)).first->second;
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
    ErasePooledOf(m_Buffers, number);
    for (auto& [id, pooled] : m_Buffers)
    {
        if (pooled.lastUse == number)
        {
            pooled.version = pooled.before; // the copies were never made
            pooled.lastUse = number - 1;
        }
    }
}

} // namespace limn::vulkan
