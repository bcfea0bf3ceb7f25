#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace limn
{

/// A cylinder with a half sphere at each end, fixed to an object.
/// Unity: UnityEngine.CapsuleCollider (2022.3), of which only ClosestPoint is here.
struct CapsuleCollider
{
    bool enabled = true;
    glm::vec3 center{0.0f}; ///< in the object's space
    float radius = 0.5f;    ///< the larger scale of the two other axes multiplies it
    float height = 1.0f;    ///< from tip to tip, times the scale of its axis; at least a sphere
    int direction = 1;      ///< the axis it stands along: 0 = x, 1 = y, 2 = z

    /// As BoxCollider::ClosestPoint.
    /// @throws ContractError if direction is none of the three
    glm::dvec3 ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                            const glm::quat& rotation, const glm::vec3& scale) const;
};

} // namespace limn
