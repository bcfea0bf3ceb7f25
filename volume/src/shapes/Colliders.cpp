#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limn/base/Diagnostic.h>
#include <limn/volume/Collider.h>
#include <string>

namespace limn
{

namespace
{

// In double throughout: beside 10 km a float has no room for the millimetres of a blend distance.

/// The point within `radius` of `middle` that is closest to `point`.
glm::dvec3 ClosestPointAround(const glm::dvec3& middle, double radius, const glm::dvec3& point)
{
    const glm::dvec3 offset = point - middle;
    const double distance = glm::length(offset);
    return distance <= radius ? point : middle + offset * (radius / distance);
}

} // namespace

glm::dvec3 BoxCollider::ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                                     const glm::quat& rotation, const glm::vec3& scale) const
{
    const glm::dquat turn = glm::normalize(glm::dquat(rotation));
    const glm::dvec3 scaling(scale);
    const glm::dvec3 middle = glm::dvec3(position) + turn * (scaling * glm::dvec3(center));
    const glm::dvec3 halfSize = glm::abs(glm::dvec3(size) * scaling) * 0.5;
    const glm::dvec3 inBox = glm::conjugate(turn) * (glm::dvec3(point) - middle);
    const glm::dvec3 clamped = glm::clamp(inBox, -halfSize, halfSize);
    // Inside, the point itself: turning it there and back would not give it exactly.
    return clamped == inBox ? glm::dvec3(point) : middle + turn * clamped;
}

glm::dvec3 SphereCollider::ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                                        const glm::quat& rotation, const glm::vec3& scale) const
{
    const glm::dquat turn = glm::normalize(glm::dquat(rotation));
    const glm::dvec3 scaling(scale);
    const glm::dvec3 lengths = glm::abs(scaling);
    const double scaledRadius =
        std::abs(static_cast<double>(radius)) * std::max(lengths.x, std::max(lengths.y, lengths.z));
    return ClosestPointAround(glm::dvec3(position) + turn * (scaling * glm::dvec3(center)),
                              scaledRadius, point);
}

glm::dvec3 CapsuleCollider::ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                                         const glm::quat& rotation, const glm::vec3& scale) const
{
    if (direction < 0 || direction > 2)
    {
        throw ContractError("a capsule collider's direction is " + std::to_string(direction) +
                            "; it must be 0 (x), 1 (y) or 2 (z)");
    }
    const glm::dquat turn = glm::normalize(glm::dquat(rotation));
    const glm::dvec3 scaling(scale);
    const glm::dvec3 lengths = glm::abs(scaling);
    const double across = std::max(lengths[(direction + 1) % 3], lengths[(direction + 2) % 3]);
    const double scaledRadius = std::abs(static_cast<double>(radius)) * across;
    const double halfHeight = std::abs(static_cast<double>(height)) * lengths[direction] * 0.5;
    const double reach = std::max(halfHeight - scaledRadius, 0.0);

    glm::dvec3 axis(0.0);
    axis[direction] = 1.0;
    axis = turn * axis;
    const glm::dvec3 middle = glm::dvec3(position) + turn * (scaling * glm::dvec3(center));
    const double along = glm::clamp(glm::dot(glm::dvec3(point) - middle, axis), -reach, reach);
    return ClosestPointAround(middle + axis * along, scaledRadius, point);
}

} // namespace limn
