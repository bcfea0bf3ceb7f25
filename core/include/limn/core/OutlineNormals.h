#pragma once

#include <limn/core/Mesh.h>
#include <memory>

namespace limn
{

/// The longest outline normal: where faces meet more sharply than 29 degrees, the hull's tip is cut
/// short.
inline constexpr float k_OutlineMiterLimit = 4.0f;

/// For each vertex the way a hull of thickness 1 moves it, in object space: all vertices at one
/// position get the same, so that the hull does not tear. Its direction is the mean of the normals
/// of the faces that meet there, each weighted by its angle at the corner, so that it does not
/// depend on how a face is cut into triangles; its length is 1 / the cosine of the angle to the
/// face that is farthest from it, so that no side of the hull gets thinner than 1, at most
/// k_OutlineMiterLimit. A cube's corner gives (+-1, +-1, +-1). Shells that merely share a position
/// are told apart by the edges of their triangles. Zero where no triangle with an area is or
/// the faces cancel each other out: there a hull has to go by something else.
std::vector<glm::vec3> BakeOutlineNormals(const MeshData& data);

/// The mesh with BakeOutlineNormals in its uv8, as a new mesh of the same name.
std::shared_ptr<const Mesh> WithOutlineNormals(const Mesh& mesh);

} // namespace limn
