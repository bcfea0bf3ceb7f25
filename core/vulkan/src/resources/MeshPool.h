#pragma once

#include "memory/LinearMemory.h"
#include <limn/core/Mesh.h>
#include <unordered_map>

namespace limn::vulkan
{

/// What a vertex function can read; the order is that of the data in a PooledMesh's buffer.
enum class VertexAttribute
{
    Position,
    Normal,
    Tangent,
    Color,
    Uv,
    Uv8,
    None ///< a semantic no mesh carries: reads as zero
};

/// The buffer behind one mesh: its attribute arrays and then its indices.
struct PooledMesh
{
    struct Array
    {
        VkDeviceSize offset = 0;
        VkDeviceSize stride = 0; ///< 0 = the mesh lacks it
    };

    std::weak_ptr<const Mesh> owner;
    Buffer buffer;
    Array arrays[6]; ///< by VertexAttribute
    VkDeviceSize indexOffset = 0;
    std::uint64_t createdBy = 0;
    std::uint64_t lastUse = 0;
};

/// All mesh buffers, found by their mesh; made and freed as ImagePool does.
class MeshPool
{
public:
    MeshPool(VkDevice device, MemoryAllocator& allocator);

    PooledMesh& Use(const std::shared_ptr<const Mesh>& mesh, std::uint64_t number);
    void RecordUploads(VkCommandBuffer commands, LinearMemory& staging);
    void Rollback(std::uint64_t number) noexcept;
    void Sweep(std::uint64_t finished);
    std::size_t size() const { return m_Meshes.size(); }
    std::uint64_t uploadCount() const { return m_UploadCount; } ///< since construction

    /// One value of each attribute for meshes that lack it, to be read with stride 0: normal +z,
    /// tangent (1, 0, 0, 1), white, all else 0.
    VkBuffer constants() const { return m_Constants.handle.get(); }
    static VkDeviceSize ConstantOffset(VertexAttribute attribute);

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
