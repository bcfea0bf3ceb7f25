#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <limn/core/Mesh.h>
#include <memory>
#include <variant>

namespace limn
{

/// A box fixed to an object; it is the space that a local volume fills.
/// Unity: UnityEngine.BoxCollider (2022.3), of which only ClosestPoint is here.
struct BoxCollider
{
    bool enabled = true;
    glm::vec3 center{0.0f}; ///< in the object's space
    glm::vec3 size{1.0f};   ///< full lengths of the edges in the object's space

    /// Returns the point in the box or on its surface that is closest to `point`. All values are in
    /// world space; the result is not yet rounded to floats. Negative sizes and scales count as
    /// positive.
    /// @param rotation  has unit length, except for rounding errors
    glm::dvec3 ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                            const glm::quat& rotation, const glm::vec3& scale) const;
};

/// A sphere fixed to an object. Unity: UnityEngine.SphereCollider (2022.3), of which only
/// ClosestPoint is here.
struct SphereCollider
{
    bool enabled = true;
    glm::vec3 center{0.0f}; ///< in the object's space
    float radius = 0.5f;    ///< in the object's space; the longest axis of its scale multiplies it

    /// Returns the closest point like BoxCollider::ClosestPoint.
    glm::dvec3 ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                            const glm::quat& rotation, const glm::vec3& scale) const;
};

/// A cylinder with a half sphere at each end, fixed to an object.
/// Unity: UnityEngine.CapsuleCollider (2022.3), of which only ClosestPoint is here.
struct CapsuleCollider
{
    bool enabled = true;
    glm::vec3 center{0.0f}; ///< in the object's space
    float radius = 0.5f;    ///< the larger scale of the two other axes multiplies it
    float height = 1.0f;    ///< from tip to tip, times the scale of its axis; at least a sphere
    int direction = 1;      ///< the axis it stands along: 0 = x, 1 = y, 2 = z

    /// Returns the closest point like BoxCollider::ClosestPoint.
    /// @throws ContractError if direction is none of the three
    glm::dvec3 ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                            const glm::quat& rotation, const glm::vec3& scale) const;
};

/// The solid that a convex mesh encloses, fixed to an object. A flat mesh is a solid without
/// thickness. Unity: UnityEngine.MeshCollider with `convex` (2022.3), of which only ClosestPoint is
/// here. Unity takes the hull of a mesh that is not convex; limn rejects such a mesh.
class MeshCollider
{
public:
    bool enabled = true;

    /// @throws ContractError, naming the mesh, if there is none, if it has no triangle, is open
    ///     without being flat, or has vertices on both sides of one of its triangles
    explicit MeshCollider(std::shared_ptr<const Mesh> mesh);

    const Mesh& mesh() const { return *m_Mesh; }

    /// Returns the closest point like BoxCollider::ClosestPoint. Looks at every triangle.
    glm::dvec3 ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                            const glm::quat& rotation, const glm::vec3& scale) const;

private:
    std::shared_ptr<const Mesh> m_Mesh;
};

/// The shape of a local volume: one of those that Unity's Collider.ClosestPoint supports.
/// Unity: UnityEngine.Collider (2022.3).
using Collider = std::variant<BoxCollider, SphereCollider, CapsuleCollider, MeshCollider>;

} // namespace limn
