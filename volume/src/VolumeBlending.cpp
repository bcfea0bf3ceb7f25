#include "VolumeBlending.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace limn
{

namespace
{

/// Infinite without an enabled collider.
float SquaredDistance(const Volume& volume, const glm::vec3& trigger)
{
    float closest = std::numeric_limits<float>::infinity();
    const auto measure = [&](const auto& collider)
    {
        if (collider.enabled)
        {
            const glm::vec3 offset =
                collider.ClosestPoint(trigger, volume.position, volume.rotation, volume.scale) -
                trigger;
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
    const float distance2 = SquaredDistance(volume, *trigger);
    const float blend2 = volume.blendDistance * volume.blendDistance;
    if (distance2 > blend2 || std::isinf(distance2))
    {
        return std::nullopt;
    }
    const float fade = blend2 > 0.0f ? 1.0f - distance2 / blend2 : 1.0f;
    return VolumeInfluence{fade * weight, weight, distance2};
}

} // namespace limn
