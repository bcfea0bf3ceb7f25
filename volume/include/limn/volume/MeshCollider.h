#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <limn/core/Mesh.h>
#include <memory>

namespace limn
{

/// The solid that a convex mesh encloses, fixed to an object; a flat mesh is a solid without
/// thickness. Unity: UnityEngine.MeshCollider with `convex` (2022.3), of which only ClosestPoint is
/// here. Unity takes the hull of a mesh that is not convex; here it is refused.
class MeshCollider
{
public:
    bool enabled = true;

    /// @throws ContractError, naming the mesh, if there is none, if it has no triangle, is open
    ///     without being flat, or has vertices on both sides of one of its triangles
    explicit MeshCollider(std::shared_ptr<const Mesh> mesh);

    const Mesh& mesh() const { return *m_Mesh; }

    /// As BoxCollider::ClosestPoint. Looks at every triangle.
    glm::dvec3 ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                            const glm::quat& rotation, const glm::vec3& scale) const;

private:
    std::shared_ptr<const Mesh> m_Mesh;
};

} // namespace limn
