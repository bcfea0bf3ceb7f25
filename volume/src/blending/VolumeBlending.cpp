#include "blending/VolumeBlending.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace limn
{

namespace
{

/// Infinite without an enabled collider. In double: the square of a float need not fit in one.
double SquaredDistance(const Volume& volume, const glm::vec3& trigger)
{
    double closest = std::numeric_limits<double>::infinity();
    const auto measure = [&](const auto& collider)
    {
        if (collider.enabled)
        {
            const glm::dvec3 point =
                collider.ClosestPoint(trigger, volume.position, volume.rotation, volume.scale);
            const glm::dvec3 offset = point - glm::dvec3(trigger);
            closest = std::min(closest, glm::dot(offset, offset));
        }
    };
    for (const Collider& collider : volume.colliders)
    {
        std::visit(measure, collider);
    }
    return closest;
}

} // namespace

std::optional<VolumeInfluence> InfluenceOf(const Volume& volume,
                                           const std::optional<glm::vec3>& trigger)
{
    // A weight that is NaN is not above 0 either.
    if (!volume.enabled || !volume.profileRef() || !(volume.weight > 0.0f))
    {
        return std::nullopt;
    }
    const float weight = std::min(volume.weight, 1.0f);
    if (volume.isGlobal)
    {
        return VolumeInfluence{weight, weight, std::nullopt};
    }
    if (!trigger)
    {
        return std::nullopt;
    }
    const double distance2 = SquaredDistance(volume, *trigger);
    const auto blendDistance = static_cast<double>(volume.blendDistance);
    const double blend2 = blendDistance * blendDistance;
    if (distance2 > blend2 || std::isinf(distance2))
    {
        return std::nullopt;
    }
    const double fade = blend2 > 0.0 ? 1.0 - distance2 / blend2 : 1.0;
    return VolumeInfluence{static_cast<float>(fade * static_cast<double>(weight)), weight,
                           distance2};
}

} // namespace limn
