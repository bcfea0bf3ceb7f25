#pragma once

#include <array>
#include <cstddef>
#include <limn/core/Mesh.h>
#include <span>
#include <string_view>

namespace limn
{

/// An array of MeshData, as a vertex function reads it.
struct VertexAttribute
{
    std::string_view semantic;    ///< "TEXCOORD0"
    std::string_view array;       ///< MeshData's name of it: "uv"
    std::size_t components;       ///< floats a vertex
    std::array<float, 4> missing; ///< what a mesh that lacks the array gives
    std::span<const float> (*values)(const MeshData& data);
};

inline constexpr std::size_t k_VertexAttributeCount = 12;

/// All arrays of MeshData but the indices.
const std::array<VertexAttribute, k_VertexAttributeCount>& VertexAttributes();

} // namespace limn
