#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace limn
{

/// Returns the rotation of Euler angles in degrees: about z, then x, then y, world axes.
/// Unity: Quaternion.Euler.
glm::quat EulerToRotation(const glm::vec3& degrees);

/// Returns the rotation that looks along `forward` with `up` upwards; both need not be unit length.
/// @throws ContractError if forward is zero. Unity: Quaternion.LookRotation.
glm::quat LookRotation(const glm::vec3& forward, const glm::vec3& up = {0.0f, 1.0f, 0.0f});

/// A position, rotation and scale in the parent's space, or in world space without a parent.
/// Unity: UnityEngine.Transform (2022.3).
struct Transform
{
    glm::vec3 localPosition{0.0f};       ///< metres
    glm::quat localRotation{1, 0, 0, 0}; ///< w, x, y, z
    glm::vec3 localScale{1.0f};
    const Transform* parent = nullptr; ///< must outlive this

    glm::mat4 localToParentMatrix() const;
    // These throw ContractError if the parents form a cycle.
    glm::mat4 localToWorldMatrix() const { return glm::mat4(worldMatrix()); }
    glm::vec3 position() const { return glm::vec3(worldMatrix()[3]); } ///< world
    /// world; ignores all scales, also those of the parents
    glm::quat rotation() const { return glm::quat(worldRotation()); }
    // These return the values before they are rounded: far away from the world's origin a float is
    // coarse.
    glm::dmat4 worldMatrix() const;
    glm::dquat worldRotation() const;
    /// world, +z turned by rotation(), unit length
    glm::vec3 forward() const { return rotation() * glm::vec3(0, 0, 1); }
};

} // namespace limn
