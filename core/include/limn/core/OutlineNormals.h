#pragma once

#include <limn/core/Mesh.h>
#include <memory>

namespace limn
{

/// The length of the longest outline normal: where faces meet more sharply than 29 degrees, the
/// hull's tip is cut short.
inline constexpr float k_OutlineMiterLimit = 4.0f;

/// Returns for each vertex the vector by which a hull of thickness 1 moves it, in object space.
/// Vertices at exactly the same position get the same vector if their triangles are connected by
/// edges, so that the hull does not tear; shells that merely touch in a point stay apart. The
/// direction is the mean of the normals of the faces that meet there, each weighted by its angle at
/// the corner, so that it does not depend on how a face is cut into triangles. The length is 1 /
/// the cosine of the angle to the face that is farthest from it, so that no side of the hull gets
/// thinner than 1, but at most k_OutlineMiterLimit: a cube's corner gives (+-1, +-1, +-1). The
/// vector is zero for vertices of no triangle with an area, and where the faces cancel each other
/// out: a hull must use something else there.
std::vector<glm::vec3> BakeOutlineNormals(const Mesh& mesh);

/// Returns a new mesh of the same name with BakeOutlineNormals in its uv8.
std::shared_ptr<const Mesh> WithOutlineNormals(const Mesh& mesh);

} // namespace limn
