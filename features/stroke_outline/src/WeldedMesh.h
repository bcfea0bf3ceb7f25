#pragma once

#include <array>
#include <cstdint>
#include <limn/core/Mesh.h>
#include <vector>

namespace limn
{

/// The triangles of a sub-mesh and their sides; vertices at one position are one point. Triangles
/// with two corners at one point are removed, and so are all but one of the triangles with the same
/// corners. Where corners of small triangles lie on the side of a large one (T-junctions), that
/// side is split there.
struct WeldedMesh
{
    struct Face
    {
        std::array<std::uint32_t, 3> points;
    };
    /// An edge of one face. All sides of one edge, however many faces meet there, are consecutive.
    struct Side
    {
        std::array<std::uint32_t, 2> points; ///< in ascending order
        std::uint32_t face;
        bool isForward; ///< whether the face's corners follow each other in this order
    };

    std::vector<glm::vec3> points; ///< object space
    std::vector<Face> faces;
    std::vector<Side> sides;
};

WeldedMesh Weld(const Mesh& mesh, int subMesh);

} // namespace limn
