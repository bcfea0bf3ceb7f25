#include <limn/core/Mesh.h>

namespace limn
{

namespace
{

template <auto Array>
std::span<const float> ValuesOf(const MeshData& data)
{
    const auto& values = data.*Array;
    using Vector = typename std::remove_cvref_t<decltype(values)>::value_type;
    static_assert(sizeof(Vector) == sizeof(float) * Vector::length());
    return {reinterpret_cast<const float*>(values.data()), values.size() * Vector::length()};
}

} // namespace

const std::array<VertexAttribute, k_VertexAttributeCount>& VertexAttributes()
{
    static constexpr std::array<VertexAttribute, k_VertexAttributeCount> attributes{{
        {"POSITION", "vertices", 3, {0, 0, 0, 0}, &ValuesOf<&MeshData::vertices>},
        {"NORMAL", "normals", 3, {0, 0, 1, 0}, &ValuesOf<&MeshData::normals>},
        {"TANGENT", "tangents", 4, {1, 0, 0, 1}, &ValuesOf<&MeshData::tangents>},
        {"COLOR", "colors", 4, {1, 1, 1, 1}, &ValuesOf<&MeshData::colors>},
        {"TEXCOORD0", "uv", 2, {0, 0, 0, 0}, &ValuesOf<&MeshData::uv>},
        {"TEXCOORD1", "uv2", 4, {0, 0, 0, 0}, &ValuesOf<&MeshData::uv2>},
        {"TEXCOORD2", "uv3", 4, {0, 0, 0, 0}, &ValuesOf<&MeshData::uv3>},
        {"TEXCOORD3", "uv4", 4, {0, 0, 0, 0}, &ValuesOf<&MeshData::uv4>},
        {"TEXCOORD4", "uv5", 4, {0, 0, 0, 0}, &ValuesOf<&MeshData::uv5>},
        {"TEXCOORD5", "uv6", 4, {0, 0, 0, 0}, &ValuesOf<&MeshData::uv6>},
        {"TEXCOORD6", "uv7", 4, {0, 0, 0, 0}, &ValuesOf<&MeshData::uv7>},
        {"TEXCOORD7", "uv8", 3, {0, 0, 0, 0}, &ValuesOf<&MeshData::uv8>},
    }};
    return attributes;
}

} // namespace limn
