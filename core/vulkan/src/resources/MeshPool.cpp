#include "resources/MeshPool.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace limn::vulkan
{

namespace
{

/// The capacity of a shared block, which holds some hundred small meshes.
constexpr MeshSize k_SharedCapacity{4096, 16384};

/// Returns whether it leaves a shared block room for others.
bool isSmall(const MeshSize& size)
{
    return size.vertices <= k_SharedCapacity.vertices / 4 &&
           size.indices <= k_SharedCapacity.indices / 4;
}

/// Returns the values that meshes without an attribute have, one for each attribute, and zeros
/// behind them.
std::array<std::array<float, 4>, k_VertexAttributeCount + 1> Constants()
{
    std::array<std::array<float, 4>, k_VertexAttributeCount + 1> constants{};
    std::ranges::transform(VertexAttributes(), constants.begin(), &VertexAttribute::missing);
    return constants;
}

} // namespace

AttributeSet AttributesOf(const MeshData& data)
{
    AttributeSet set;
    for (std::size_t i = 0; i < k_VertexAttributeCount; ++i)
    {
        set[i] = !VertexAttributes()[i].values(data).empty();
    }
    return set;
}

MeshSize SizeOf(const MeshData& data)
{
    return {static_cast<std::uint32_t>(std::max<std::size_t>(data.vertices.size(), 1)),
            static_cast<std::uint32_t>(std::max<std::size_t>(data.triangles.size(), 1))};
}

MeshBlock::MeshBlock(VkDevice device, MemoryAllocator& allocator, const AttributeSet& attributes,
                     const MeshSize& capacity, const std::string& name)
    : m_Attributes(attributes), m_Vertices(capacity.vertices), m_Indices(capacity.indices)
{
    VkDeviceSize end = IndexOffset(capacity.indices);
    for (std::size_t i = 0; i < k_VertexAttributeCount; ++i)
    {
        m_Arrays[i] = end;
        end += attributes[i] ? Stride(i) * capacity.vertices : 0;
    }
    m_Buffer = Buffer{device,
                      allocator,
                      end,
                      VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT |
                          VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                      MemoryUse::Gpu,
                      name};
}

std::optional<MeshBlock::Range> MeshBlock::Allocate(const MeshSize& size)
{
    const auto vertex = m_Vertices.Allocate(size.vertices, 1);
    if (!vertex)
    {
        return std::nullopt;
    }
    const auto index = m_Indices.Allocate(size.indices, 1);
    if (!index)
    {
        m_Vertices.Free(*vertex, size.vertices);
        return std::nullopt;
    }
    return Range{static_cast<std::uint32_t>(*vertex), static_cast<std::uint32_t>(*index), size};
}

void MeshBlock::Free(const Range& range)
{
    m_Vertices.Free(range.firstVertex, range.size.vertices);
    m_Indices.Free(range.firstIndex, range.size.indices);
}

VkDeviceSize MeshBlock::ArrayOffset(std::size_t attribute, std::uint32_t vertex) const
{
    return m_Arrays[attribute] + Stride(attribute) * vertex;
}

VkDeviceSize MeshBlock::IndexOffset(std::uint32_t index)
{
    return sizeof(std::uint32_t) * VkDeviceSize{index};
}

VkDeviceSize MeshBlock::Stride(std::size_t attribute)
{
    return VertexAttributes()[attribute].components * sizeof(float);
}

MeshPool::MeshPool(VkDevice device, MemoryAllocator& allocator)
    : m_Device(device),
      m_Allocator(allocator),
      m_Constants(device, allocator, sizeof(Constants()), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT,
                  MemoryUse::Upload, "missing vertex attributes")
{
    const auto constants = Constants();
    std::memcpy(m_Constants.memory.mapped(), constants.data(), sizeof(constants));
}

PooledMesh& MeshPool::Use(Meshes& meshes, const std::shared_ptr<const Mesh>& mesh,
                          std::uint64_t number, bool alone)
{
    if (PooledMesh* found = FindPooled(meshes, mesh->id()))
    {
        found->lastUse = number;
        return *found;
    }
    PooledMesh pooled;
    pooled.owner = mesh;
    pooled.createdBy = number;
    pooled.lastUse = number;
    Place(pooled, *mesh, alone);
    PooledMesh& stored = meshes.emplace(mesh->id(), std::move(pooled)).first->second;
    m_Uploads.push_back({&stored, mesh});
    return stored;
}

void MeshPool::Place(PooledMesh& pooled, const Mesh& mesh, bool alone)
{
    const AttributeSet attributes = AttributesOf(mesh.data());
    const MeshSize size = SizeOf(mesh.data());
    if (!alone && isSmall(size))
    {
        PlaceInShared(pooled, attributes, size);
        return;
    }
    pooled.own = std::make_unique<MeshBlock>(m_Device, m_Allocator, attributes, size, mesh.name());
    pooled.block = pooled.own.get();
    pooled.range = pooled.block->Allocate(size).value();
}

void MeshPool::PlaceInShared(PooledMesh& pooled, const AttributeSet& attributes,
                             const MeshSize& size)
{
    const auto placed = [&](MeshBlock& block)
    {
        const auto range = block.attributes() == attributes ? block.Allocate(size) : std::nullopt;
        if (range)
        {
            pooled.block = &block;
            pooled.range = *range;
        }
        return range.has_value();
    };
    if (std::ranges::none_of(m_Shared, [&](const auto& block) { return placed(*block); }))
    {
        m_Shared.push_back(std::make_unique<MeshBlock>(m_Device, m_Allocator, attributes,
                                                       k_SharedCapacity, "small meshes"));
        placed(*m_Shared.back());
    }
}

void MeshPool::RecordUploads(UploadCommands& uploads)
{
    if (m_Uploads.empty())
    {
        return;
    }
    for (const Upload& upload : m_Uploads)
    {
        RecordUpload(upload, uploads);
    }
    RecordBarrier(uploads.commands(),
                  {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                  {VK_PIPELINE_STAGE_2_VERTEX_INPUT_BIT,
                   VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT | VK_ACCESS_2_INDEX_READ_BIT});
    m_UploadCount += m_Uploads.size();
    m_Uploads.clear();
}

void MeshPool::RecordUpload(const Upload& upload, UploadCommands& uploads) const
{
    const MeshData& data = upload.mesh->data();
    const MeshBlock& block = *upload.pooled->block;
    const auto copy = [&](std::span<const std::byte> bytes, VkDeviceSize offset)
    {
        const UploadedBytes staged = uploads.staging().Upload(bytes);
        const VkBufferCopy region{staged.offset, offset, bytes.size()};
        vkCmdCopyBuffer(uploads.commands(), staged.buffer, block.buffer(), 1, &region);
    };
    if (!data.triangles.empty())
    {
        copy(std::as_bytes(std::span{data.triangles}),
             MeshBlock::IndexOffset(upload.pooled->range.firstIndex));
    }
    for (std::size_t i = 0; i < k_VertexAttributeCount; ++i)
    {
        if (block.attributes()[i])
        {
            copy(std::as_bytes(VertexAttributes()[i].values(data)),
                 block.ArrayOffset(i, upload.pooled->range.firstVertex));
        }
    }
}

void MeshPool::AddUses(std::uint64_t number, std::vector<std::uint64_t*>& uses)
{
    AddPooledUses(m_Meshes, number, uses);
    AddPooledUses(m_Alone, number, uses);
}

/// Erases the meshes that meet the condition, and the shared blocks that become empty.
template <typename Condition>
void MeshPool::Erase(const Condition& condition)
{
    std::size_t erased = 0;
    for (Meshes* meshes : {&m_Meshes, &m_Alone})
    {
        erased += std::erase_if(*meshes,
                                [&](auto& entry)
                                {
                                    const bool isOver = condition(entry.second);
                                    if (isOver)
                                    {
                                        entry.second.block->Free(entry.second.range);
                                    }
                                    return isOver;
                                });
    }
    if (erased > 0)
    {
        m_Freed += erased;
        std::erase_if(m_Shared, [](const auto& block) { return block->isEmpty(); });
    }
}

void MeshPool::Rollback(std::uint64_t number) noexcept
{
    m_Uploads.clear();
    Erase([&](const PooledMesh& mesh) { return mesh.createdBy == number; });
    UndoPooledUses(m_Meshes, number);
    UndoPooledUses(m_Alone, number);
}

void MeshPool::Sweep(std::uint64_t finished)
{
    Erase([&](const PooledMesh& mesh) { return mesh.owner.expired() && mesh.lastUse <= finished; });
}

} // namespace limn::vulkan
