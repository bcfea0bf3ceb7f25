#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limn/shaderlab/Diagnostic.h>
#include <limn/volume/BoxCollider.h>
#include <limn/volume/CapsuleCollider.h>
#include <limn/volume/SphereCollider.h>
#include <string>

namespace limn
{

namespace
{

/// The point within `radius` of `middle` that is closest to `point`.
glm::vec3 ClosestPointAround(const glm::vec3& middle, float radius, const glm::vec3& point)
{
    // In double: the square of a length within a float need not fit in one.
    const glm::dvec3 offset = glm::dvec3(point) - glm::dvec3(middle);
    const double distance = glm::length(offset);
    return distance <= static_cast<double>(radius)
               ? point
               : glm::vec3(glm::dvec3(middle) + offset * (static_cast<double>(radius) / distance));
}

} // namespace

glm::vec3 BoxCollider::ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                                    const glm::quat& rotation, const glm::vec3& scale) const
{
    const glm::vec3 middle = position + rotation * (scale * center);
    const glm::vec3 halfSize = glm::abs(size * scale) * 0.5f;
    const glm::vec3 inBox = glm::conjugate(rotation) * (point - middle);
    const glm::vec3 clamped = glm::clamp(inBox, -halfSize, halfSize);
    // Inside, the point itself: turning it there and back would not give it exactly.
    return clamped == inBox ? point : middle + rotation * clamped;
}

glm::vec3 SphereCollider::ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                                       const glm::quat& rotation, const glm::vec3& scale) const
{
    const glm::vec3 lengths = glm::abs(scale);
    const float scaledRadius =
        std::abs(radius) * std::max(lengths.x, std::max(lengths.y, lengths.z));
    return ClosestPointAround(position + rotation * (scale * center), scaledRadius, point);
}

glm::vec3 CapsuleCollider::ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                                        const glm::quat& rotation, const glm::vec3& scale) const
{
    if (direction < 0 || direction > 2)
    {
        throw ContractError("a capsule collider's direction is " + std::to_string(direction) +
                            "; it must be 0 (x), 1 (y) or 2 (z)");
    }
    const glm::vec3 lengths = glm::abs(scale);
    const float across = std::max(lengths[(direction + 1) % 3], lengths[(direction + 2) % 3]);
    const float scaledRadius = std::abs(radius) * across;
    const float halfHeight = std::abs(height) * lengths[direction] * 0.5f;
    const float reach = std::max(halfHeight - scaledRadius, 0.0f);

    glm::vec3 axis(0.0f);
    axis[direction] = 1.0f;
    axis = rotation * axis;
    const glm::vec3 middle = position + rotation * (scale * center);
    const float along = glm::clamp(glm::dot(point - middle, axis), -reach, reach);
    return ClosestPointAround(middle + axis * along, scaledRadius, point);
}

} // namespace limn
