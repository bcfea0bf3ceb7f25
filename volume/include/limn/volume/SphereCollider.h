#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace limn
{

/// A sphere fixed to an object. Unity: UnityEngine.SphereCollider (2022.3), of which only
/// ClosestPoint is here.
struct SphereCollider
{
    bool enabled = true;
    glm::vec3 center{0.0f}; ///< in the object's space
    float radius = 0.5f;    ///< in the object's space; the longest axis of its scale multiplies it

    /// As BoxCollider::ClosestPoint.
    glm::dvec3 ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                            const glm::quat& rotation, const glm::vec3& scale) const;
};

} // namespace limn
