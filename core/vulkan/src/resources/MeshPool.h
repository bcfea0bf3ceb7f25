#pragma once

#include "memory/UploadCommands.h"
#include "resources/Pooled.h"
#include <bitset>
#include <limn/core/Mesh.h>
#include <optional>

namespace limn::vulkan
{

/// The set of VertexAttributes() that a mesh has.
using AttributeSet = std::bitset<k_VertexAttributeCount>;

AttributeSet AttributesOf(const MeshData& data);

/// The numbers of vertices and of indices.
struct MeshSize
{
    std::uint32_t vertices = 0;
    std::uint32_t indices = 0;
};

/// Returns the size of a mesh, which is at least one vertex and one index, because Vulkan has no
/// empty buffers.
MeshSize SizeOf(const MeshData& data);

/// A buffer that meshes with the same attributes share, so that draws of different meshes need no
/// other binding. It has all indices, and behind them an array of each attribute. The indices come
/// first, because lavapipe 22.3.6 draws nothing with vkCmdDrawIndexedIndirect if they are bound at
/// an offset.
class MeshBlock
{
public:
    MeshBlock(VkDevice device, MemoryAllocator& allocator, const AttributeSet& attributes,
              const MeshSize& capacity, const std::string& name);

    /// The place of a mesh, counted in vertices and in indices.
    struct Range
    {
        std::uint32_t firstVertex = 0;
        std::uint32_t firstIndex = 0;
        MeshSize size;
    };

    /// Returns a place for a mesh, or nullopt if there is not enough room.
    std::optional<Range> Allocate(const MeshSize& size);
    void Free(const Range& range);
    bool isEmpty() const { return m_Vertices.usedBytes() == 0; }

    const AttributeSet& attributes() const { return m_Attributes; }
    VkBuffer buffer() const { return m_Buffer.handle.get(); }
    /// @pre attributes()[attribute]
    VkDeviceSize ArrayOffset(std::size_t attribute, std::uint32_t vertex) const;
    static VkDeviceSize IndexOffset(std::uint32_t index);
    static VkDeviceSize Stride(std::size_t attribute);

private:
    AttributeSet m_Attributes;
    RangeAllocator m_Vertices;
    RangeAllocator m_Indices;
    std::array<VkDeviceSize, k_VertexAttributeCount> m_Arrays{};
    Buffer m_Buffer;
};

/// The place of a mesh on the device.
struct PooledMesh
{
    std::weak_ptr<const Mesh> owner;
    MeshBlock* block = nullptr;
    MeshBlock::Range range;
    std::unique_ptr<MeshBlock> own; ///< `block`, if no other mesh is in it
    std::uint64_t createdBy = 0;
    std::uint64_t lastUse = 0;
};

/// All meshes of the device, made and freed like the images of ImagePool. Small meshes with the
/// same attributes share blocks.
class MeshPool
{
public:
    MeshPool(VkDevice device, MemoryAllocator& allocator);

    PooledMesh& Use(const std::shared_ptr<const Mesh>& mesh, std::uint64_t number)
    {
        return Use(m_Meshes, mesh, number, false);
    }
    /// Returns the mesh in a block of its own. It begins there with vertex 0 and index 0, because
    /// the counts of an indirect draw assume so.
    PooledMesh& UseDedicatedBuffer(const std::shared_ptr<const Mesh>& mesh, std::uint64_t number)
    {
        return Use(m_Alone, mesh, number, true);
    }
    void RecordUploads(UploadCommands& uploads);
    /// Adds the PooledMesh::lastUse of the meshes that submission `number` uses.
    void AddUses(std::uint64_t number, std::vector<std::uint64_t*>& uses);
    void Rollback(std::uint64_t number) noexcept;
    void Sweep(std::uint64_t finished);
    std::size_t size() const { return m_Meshes.size() + m_Alone.size(); }
    std::uint64_t uploadCount() const { return m_UploadCount; } ///< since construction
    std::uint64_t freedCount() const { return m_Freed; }        ///< likewise

    /// Returns a buffer with one value of each attribute, which is read with stride 0 for meshes
    /// that lack the attribute, and zeros for what no mesh has.
    VkBuffer constants() const { return m_Constants.handle.get(); }
    /// @param attribute  an index of VertexAttributes(), or their number for none of them
    static VkDeviceSize ConstantOffset(std::size_t attribute)
    {
        return attribute * sizeof(VertexAttribute::missing);
    }

private:
    using Meshes = std::unordered_map<std::uint64_t, PooledMesh>; ///< by Mesh::id

    struct Upload
    {
        PooledMesh* pooled = nullptr;
        std::shared_ptr<const Mesh> mesh;
    };

    PooledMesh& Use(Meshes& meshes, const std::shared_ptr<const Mesh>& mesh, std::uint64_t number,
                    bool alone);
    void Place(PooledMesh& pooled, const Mesh& mesh, bool alone);
    void PlaceInShared(PooledMesh& pooled, const AttributeSet& attributes, const MeshSize& size);
    void RecordUpload(const Upload& upload, UploadCommands& uploads) const;
    template <typename Condition>
    void Erase(const Condition& condition);

    VkDevice m_Device;
    MemoryAllocator& m_Allocator;
    Buffer m_Constants;
    std::vector<std::unique_ptr<MeshBlock>> m_Shared;
    Meshes m_Meshes;
    Meshes m_Alone;
    std::vector<Upload> m_Uploads;
    std::uint64_t m_UploadCount = 0;
    std::uint64_t m_Freed = 0;
};

} // namespace limn::vulkan
