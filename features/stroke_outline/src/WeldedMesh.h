#pragma once

#include <array>
#include <cstdint>
#include <limn/core/Mesh.h>
#include <vector>

namespace limn
{

/// The triangles of a sub-mesh and what lies between them: vertices at one position are one point.
/// Triangles with two corners at one point are left out.
struct WeldedMesh
{
    static constexpr std::uint32_t k_NoFace = ~std::uint32_t{0};

    struct Face
    {
        std::array<std::uint32_t, 3> points;
    };
    struct Edge
    {
        std::array<std::uint32_t, 2> points;
        /// The two faces that meet here; the second is k_NoFace at a border, and where more than
        /// two meet there is one edge for each face, all of them borders.
        std::array<std::uint32_t, 2> faces{k_NoFace, k_NoFace};
    };

    std::vector<glm::vec3> points; ///< object space
    std::vector<Face> faces;
    std::vector<Edge> edges;
};

WeldedMesh Weld(const Mesh& mesh, int subMesh);

} // namespace limn
