#pragma once

#include "memory/MemoryAllocator.h"
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

} // namespace limn::vulkan
