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

/// Where a ray meets a mesh.
struct MeshHit
{
    int subMesh = 0;
    std::uint32_t firstIndex = 0; ///< of the triangle, in data().triangles
    double t = 0.0;               ///< origin + t * direction
};

/// A ray in a mesh's own space, and which of its triangles it can meet.
struct MeshRay
{
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0}; ///< any length but 0
    double maxT = 0.0;
    RaycastFaces faces = RaycastFaces::Front;
    std::vector<bool> subMeshes; ///< one for each
};

/// A tree over the triangles of one mesh. Embree computes in float; so that it does near 0 and 1,
/// wherever the vertices are, the tree has them in a sphere of radius 1, and the ray starts there.
/// The distance is computed in double from the mesh's own vertices.
class MeshTree
{
public:
    /// @throws std::bad_alloc, std::runtime_error if Embree fails
    MeshTree(RTCDevice device, const Mesh& mesh);
    ~MeshTree();
    MeshTree(const MeshTree&) = delete;
    MeshTree& operator=(const MeshTree&) = delete;

    /// The nearest triangle.
    /// @param mesh  the tree's
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

/// Whether a ray of this direction meets a side of the triangle that counts.
bool MeetsFace(const Triangle& triangle, const glm::dvec3& direction, RaycastFaces faces);

} // namespace limn
