#include "resources/MeshBlock.h"

#include <algorithm>

namespace limn::vulkan
{

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

} // namespace limn::vulkan
