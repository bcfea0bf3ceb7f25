#include "resources/ObjectPool.h"

#include <cstring>
#include <numeric>

namespace limn::vulkan
{

namespace
{

constexpr VkPipelineStageFlags2 k_Readers =
    VK_PIPELINE_STAGE_2_PRE_RASTERIZATION_SHADERS_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
constexpr UsageScope k_ObjectsCopied{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};

/// Finds the destinations of objects that lie side by side in the staging memory. Neighbours are
/// copied together.
void FindRegions(std::span<const std::uint32_t> objects, VkDeviceSize staging,
                 std::vector<VkBufferCopy>& regions)
{
    constexpr VkDeviceSize k_Size = sizeof(PerDrawData);
    regions.clear();
    for (std::size_t i = 0; i < objects.size(); ++i)
    {
        const VkDeviceSize target = objects[i] * k_Size;
        if (regions.empty() || regions.back().dstOffset + regions.back().size != target)
        {
            regions.push_back({staging + i * k_Size, target, 0});
        }
        regions.back().size += k_Size;
    }
}

void RecordCopies(const InstanceData& table, std::span<const std::uint32_t> objects,
                  VkBuffer target, UploadCommands& uploads, std::vector<VkBufferCopy>& regions)
{
    const UploadedBytes bytes = uploads.staging().Allocate(objects.size() * sizeof(PerDrawData));
    std::byte* place = bytes.mapped;
    for (const std::uint32_t object : objects)
    {
        const PerDrawData data = table.Get(object);
        std::memcpy(place, &data, sizeof data);
        place += sizeof data;
    }
    VkCommandBuffer commands = uploads.commands();
    RecordBarrier(commands, {k_Readers | k_ObjectsCopied.stages, k_ObjectsCopied.access},
                  k_ObjectsCopied);
    FindRegions(objects, bytes.offset, regions);
    vkCmdCopyBuffer(commands, bytes.buffer, target, static_cast<std::uint32_t>(regions.size()),
                    regions.data());
    RecordBarrier(commands, k_ObjectsCopied, {k_Readers, VK_ACCESS_2_SHADER_STORAGE_READ_BIT});
}

} // namespace

VkBuffer ObjectPool::Update(const std::shared_ptr<const InstanceData>& table, std::uint64_t number,
                            UploadCommands& uploads)
{
    PooledObjects& pooled = Use(table, number);
    const auto changed = pooled.version == PooledObjects::k_Unknown
                             ? std::nullopt
                             : table->ChangedSince(pooled.version);
    std::vector<std::uint32_t> all(changed ? 0 : table->count());
    std::iota(all.begin(), all.end(), 0u);
    const std::span<const std::uint32_t> objects = changed ? *changed : std::span(all);
    pooled.version = PooledObjects::k_Unknown; // until the copies are recorded
    if (!objects.empty())
    {
        RecordCopies(*table, objects, pooled.buffer.handle.get(), uploads, m_Regions);
    }
    pooled.version = table->version();
    return pooled.buffer.handle.get();
}

PooledObjects& ObjectPool::Use(const std::shared_ptr<const InstanceData>& table,
                               std::uint64_t number)
{
    const VkDeviceSize needed = table->count() * VkDeviceSize{sizeof(PerDrawData)};
    const auto found = m_Objects.find(table->id());
    VkDeviceSize size = needed;
    if (found != m_Objects.end())
    {
        found->second.lastUse = number;
        if (needed <= found->second.buffer.size)
        {
            return found->second;
        }
        size = needed + needed / 2; // it grows, and may go on to
    }
    PooledObjects pooled;
    pooled.owner = table;
    pooled.createdBy = number;
    pooled.lastUse = number;
    pooled.buffer = Buffer{
        m_Device,       m_Allocator,
        size,           VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
        MemoryUse::Gpu, "objects of a scene"};
    PooledObjects& stored = m_Objects[table->id()];
    if (stored.buffer.size > 0)
    {
        m_Outgrown.push_back(std::move(stored));
    }
    stored = std::move(pooled);
    return stored;
}

void ObjectPool::Rollback(std::uint64_t number) noexcept
{
    ErasePooledOf(m_Objects, number);
    for (auto& [id, pooled] : m_Objects)
    {
        if (pooled.lastUse == number)
        {
            pooled.version = PooledObjects::k_Unknown; // the copies were never made
        }
    }
}

void ObjectPool::Sweep(std::uint64_t finished)
{
    SweepPooled(m_Objects, finished);
    std::erase_if(m_Outgrown,
                  [&](const PooledObjects& pooled) { return pooled.lastUse <= finished; });
}

} // namespace limn::vulkan
