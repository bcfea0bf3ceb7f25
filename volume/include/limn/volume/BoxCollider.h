#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace limn
{

/// A box fixed to an object, for the space a local volume fills. Unity: UnityEngine.BoxCollider
/// (2022.3), of which only ClosestPoint is here.
struct BoxCollider
{
    bool enabled = true;
    glm::vec3 center{0.0f}; ///< in the object's space
    glm::vec3 size{1.0f};   ///< full lengths of the edges in the object's space

    /// The point of the box, inside or on its surface, that is closest to `point`, all in world
    /// space, not yet rounded to floats. Negative sizes and scales count as positive.
    /// @param rotation  of unit length but for rounding
    glm::dvec3 ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                            const glm::quat& rotation, const glm::vec3& scale) const;
};

} // namespace limn
