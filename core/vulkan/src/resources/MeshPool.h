#pragma once

#include "memory/UploadCommands.h"
#include <limn/core/VertexAttribute.h>
#include <unordered_map>

namespace limn::vulkan
{

/// The buffer behind one mesh: its indices and then its attribute arrays.
struct PooledMesh
{
    struct Array
    {
        VkDeviceSize offset = 0;
        VkDeviceSize stride = 0; ///< 0 = the mesh lacks it
    };

    std::weak_ptr<const Mesh> owner;
    Buffer buffer;
    std::array<Array, k_VertexAttributeCount> arrays; ///< by VertexAttributes()
    std::uint64_t createdBy = 0;
    std::uint64_t lastUse = 0;
};

/// All mesh buffers, found by their mesh; made and freed as ImagePool does.
class MeshPool
{
public:
    MeshPool(VkDevice device, MemoryAllocator& allocator);

    PooledMesh& Use(const std::shared_ptr<const Mesh>& mesh, std::uint64_t number);
    void RecordUploads(UploadCommands& uploads);
    /// Adds the PooledMesh::lastUse of those that submission `number` uses.
    void AddUses(std::uint64_t number, std::vector<std::uint64_t*>& uses);
    void Rollback(std::uint64_t number) noexcept;
    void Sweep(std::uint64_t finished);
    std::size_t size() const { return m_Meshes.size(); }
    std::uint64_t uploadCount() const { return m_UploadCount; } ///< since construction

    /// One value of each attribute for meshes that lack it, to be read with stride 0, and zeros for
    /// what no mesh has.
    VkBuffer constants() const { return m_Constants.handle.get(); }
    /// @param attribute  an index of VertexAttributes(), or their number: none of them
    static VkDeviceSize ConstantOffset(std::size_t attribute);

private:
    struct Upload
    {
        PooledMesh* pooled = nullptr;
        std::shared_ptr<const Mesh> mesh;
    };

    VkDevice m_Device;
    MemoryAllocator& m_Allocator;
    Buffer m_Constants;
    std::unordered_map<std::uint64_t, PooledMesh> m_Meshes; ///< by Mesh::id
    std::vector<Upload> m_Uploads;
    std::uint64_t m_UploadCount = 0;
};

} // namespace limn::vulkan
