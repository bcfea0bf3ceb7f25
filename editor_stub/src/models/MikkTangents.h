#pragma once

#include <limn/core/Mesh.h>

namespace limn
{

/// Sets a mesh's tangents by the rule of MikkTSpace (Mikkelsen 2008), by which normal maps are
/// baked for Unity: the directions of growing u of the triangles around a corner that hang together
/// in position, normal and uv and turn uv the same way round, each turned into the plane of the
/// normal and weighted by the triangle's angle there. A vertex whose triangles do not agree becomes
/// several. Without normals or uv there are none afterwards. Takes time linear in the triangles.
/// @param data  with indices that are in range
void ComputeMikkTangents(MeshData& data);

} // namespace limn
