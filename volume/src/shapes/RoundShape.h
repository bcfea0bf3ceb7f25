#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace limn
{

/// The point within `radius` of `middle` that is closest to `point`.
inline glm::vec3 ClosestPointAround(const glm::vec3& middle, float radius, const glm::vec3& point)
{
    // In double: the square of a length within a float need not fit in one.
    const glm::dvec3 offset = glm::dvec3(point) - glm::dvec3(middle);
    const double distance = glm::length(offset);
    return distance <= static_cast<double>(radius)
               ? point
               : glm::vec3(glm::dvec3(middle) + offset * (static_cast<double>(radius) / distance));
}

} // namespace limn
