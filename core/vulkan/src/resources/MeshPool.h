#pragma once

#include "memory/UploadCommands.h"
#include "resources/MeshBlock.h"
#include <unordered_map>

namespace limn::vulkan
{

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

    PooledMesh& Use(const std::shared_ptr<const Mesh>& mesh, std::uint64_t number);
    /// Returns the mesh in a block of its own. It begins there with vertex 0 and index 0, because
    /// the counts of an indirect draw assume so.
    PooledMesh& UseDedicatedBuffer(const std::shared_ptr<const Mesh>& mesh, std::uint64_t number);
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
    static VkDeviceSize ConstantOffset(std::size_t attribute);

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
