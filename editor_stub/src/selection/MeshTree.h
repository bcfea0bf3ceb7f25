#pragma once

#include <cstdint>
#include <embree3/rtcore.h>
#include <glm/vec3.hpp>
#include <limn/core/Mesh.h>
#include <limn/editor_stub/Raycast.h>
#include <optional>
#include <vector>

namespace limn
{

/// The place where a ray meets a mesh.
struct MeshHit
{
    int subMesh = 0;
    std::uint32_t firstIndex = 0; ///< the index in data().triangles at which the triangle begins
    double t = 0.0;               ///< the place is origin + t * direction
};

/// A ray in a mesh's own space, and the triangles that it can meet.
struct MeshRay
{
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0}; ///< any length but 0
    double maxT = 0.0;
    RaycastFaces faces = RaycastFaces::Front;
    std::vector<bool> subMeshes; ///< true for each sub-mesh that it can meet
};

/// A tree over the triangles of one mesh. Embree computes in float. To keep its numbers near 0 and
/// 1 wherever the vertices are, the tree has them in a sphere of radius 1, and the ray starts
/// there. The distance is computed in double from the mesh's own vertices.
class MeshTree
{
public:
    /// @throws std::bad_alloc, std::runtime_error if Embree fails
    MeshTree(RTCDevice device, const Mesh& mesh);
    ~MeshTree();
    MeshTree(const MeshTree&) = delete;
    MeshTree& operator=(const MeshTree&) = delete;

    /// Returns the nearest triangle that the ray meets.
    /// @param mesh  must be the tree's mesh
    std::optional<MeshHit> Raycast(const Mesh& mesh, const MeshRay& ray) const;

private:
    RTCScene m_Scene = nullptr;
};

/// The three corners of the triangle that begins at this index.
struct Triangle
{
    glm::dvec3 a, b, c;
};
Triangle TriangleOf(const Mesh& mesh, std::uint32_t firstIndex);

/// Returns whether a ray of this direction meets the triangle on one of the sides that `faces` has.
bool MeetsFace(const Triangle& triangle, const glm::dvec3& direction, RaycastFaces faces);

} // namespace limn
