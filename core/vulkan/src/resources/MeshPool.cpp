#include "resources/MeshPool.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace limn::vulkan
{

namespace
{

template <typename T>
std::span<const std::byte> Bytes(const std::vector<T>& values)
{
    return std::as_bytes(std::span{values});
}

/// What meshes without an attribute give, by attribute, and behind them zeros.
std::array<std::array<float, 4>, k_VertexAttributeCount + 1> Constants()
{
    std::array<std::array<float, 4>, k_VertexAttributeCount + 1> constants{};
    std::ranges::transform(VertexAttributes(), constants.begin(), &VertexAttribute::missing);
    return constants;
}

/// Lays the mesh out and returns the bytes needed, at least 4: Vulkan has no empty buffers. The
/// indices come first: lavapipe 22.3.6 draws nothing of vkCmdDrawIndexedIndirect where they are
/// bound at an offset.
VkDeviceSize LayOut(const MeshData& data, PooledMesh& pooled)
{
    VkDeviceSize end = Bytes(data.triangles).size();
    for (std::size_t i = 0; i < k_VertexAttributeCount; ++i)
    {
        const VertexAttribute& attribute = VertexAttributes()[i];
        const std::span<const float> values = attribute.values(data);
        pooled.arrays[i] = {end, values.empty() ? 0 : attribute.components * sizeof(float)};
        end += values.size_bytes();
    }
    return std::max<VkDeviceSize>(end, 4);
}

void Write(const MeshData& data, const PooledMesh& pooled, std::byte* target)
{
    const auto copy = [&](std::span<const std::byte> bytes, VkDeviceSize offset)
    {
        if (!bytes.empty())
        {
            std::memcpy(target + offset, bytes.data(), bytes.size());
        }
    };
    copy(Bytes(data.triangles), 0);
    for (std::size_t i = 0; i < k_VertexAttributeCount; ++i)
    {
        copy(std::as_bytes(VertexAttributes()[i].values(data)), pooled.arrays[i].offset);
    }
}

} // namespace

MeshPool::MeshPool(VkDevice device, MemoryAllocator& allocator)
    : m_Device(device),
      m_Allocator(allocator),
      m_Constants(device, allocator, sizeof(Constants()), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT,
                  MemoryUse::Upload, "missing vertex attributes")
{
    const auto constants = Constants();
    std::memcpy(m_Constants.memory.mapped(), constants.data(), sizeof(constants));
}

VkDeviceSize MeshPool::ConstantOffset(std::size_t attribute)
{
    return attribute * sizeof(VertexAttribute::missing);
}

PooledMesh& MeshPool::Use(const std::shared_ptr<const Mesh>& mesh, std::uint64_t number)
{
    const auto found = m_Meshes.find(mesh->id());
    if (found != m_Meshes.end())
    {
        found->second.lastUse = number;
        return found->second;
    }
    PooledMesh pooled;
    pooled.owner = mesh;
    pooled.createdBy = number;
    pooled.lastUse = number;
    const VkDeviceSize size = LayOut(mesh->data(), pooled);
    pooled.buffer = Buffer{m_Device,
                           m_Allocator,
                           size,
                           VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT |
                               VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                           MemoryUse::Gpu,
                           mesh->name()};
    PooledMesh& stored = m_Meshes.emplace(mesh->id(), std::move(pooled)).first->second;
    m_Uploads.push_back({&stored, mesh});
    return stored;
}

void MeshPool::RecordUploads(UploadCommands& uploads)
{
    if (m_Uploads.empty())
    {
        return;
    }
    VkCommandBuffer commands = uploads.commands();
    for (const Upload& upload : m_Uploads)
    {
        const VkDeviceSize size = upload.pooled->buffer.size;
        const UploadedBytes bytes = uploads.staging().Allocate(size);
        Write(upload.mesh->data(), *upload.pooled, bytes.mapped);
        const VkBufferCopy region{bytes.offset, 0, size};
        vkCmdCopyBuffer(commands, bytes.buffer, upload.pooled->buffer.handle.get(), 1, &region);
    }
    VkMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_VERTEX_INPUT_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT | VK_ACCESS_2_INDEX_READ_BIT;
    VkDependencyInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    info.memoryBarrierCount = 1;
    info.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &info);
    m_UploadCount += m_Uploads.size();
    m_Uploads.clear();
}

void MeshPool::AddUses(std::uint64_t number, std::vector<std::uint64_t*>& uses)
{
    for (auto& [id, mesh] : m_Meshes)
    {
        if (mesh.lastUse == number)
        {
            uses.push_back(&mesh.lastUse);
        }
    }
}

void MeshPool::Rollback(std::uint64_t number) noexcept
{
    m_Uploads.clear();
    std::erase_if(m_Meshes, [&](const auto& entry) { return entry.second.createdBy == number; });
    for (auto& [id, mesh] : m_Meshes)
    {
        mesh.lastUse = std::min(mesh.lastUse, number - 1);
    }
}

void MeshPool::Sweep(std::uint64_t finished)
{
    std::erase_if(m_Meshes, [&](const auto& entry)
                  { return entry.second.owner.expired() && entry.second.lastUse <= finished; });
}

} // namespace limn::vulkan
