#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace limn
{

/// The point within `radius` of `middle` that is closest to `point`.
inline glm::vec3 ClosestPointAround(const glm::vec3& middle, float radius, const glm::vec3& point)
{
    const glm::vec3 offset = point - middle;
    const float distance = glm::length(offset);
    return distance <= radius ? point : middle + offset * (radius / distance);
}

} // namespace limn
