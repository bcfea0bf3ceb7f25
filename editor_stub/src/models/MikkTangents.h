#pragma once

#include <limn/core/Mesh.h>

namespace limn
{

/// Sets a mesh's tangents by the rule of MikkTSpace (Mikkelsen 2008), by which normal maps are
/// baked for Unity. A tangent is the sum of the directions in which u grows in the triangles around
/// a corner that share position, normal and uv and turn uv the same way round. Each direction is
/// turned into the plane of the normal and weighted by the triangle's angle at the corner. A vertex
/// whose triangles do not agree becomes several vertices. A mesh without normals or uv has no
/// tangents afterwards. The time is linear in the number of triangles.
/// @param data  must have indices that are in range
/// @return for each vertex that was added, in order, the vertex that it is a copy of
std::vector<std::uint32_t> ComputeMikkTangents(MeshData& data);

} // namespace limn
