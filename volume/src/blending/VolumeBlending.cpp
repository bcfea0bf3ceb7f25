#include "blending/VolumeBlending.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iomanip>
#include <limits>
#include <limn/volume/VolumeTrace.h>
#include <sstream>

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

std::string WhyIdle(const Volume& volume, const std::optional<glm::vec3>& trigger,
                    LayerMask layerMask)
{
    std::ostringstream why;
    if (!volume.enabled)
    {
        why << "it is off";
    }
    else if (!LayerMask::FromIndex(volume.layer).Intersects(layerMask))
    {
        why << "its layer, " << volume.layer << ", is not among the camera's volume layers";
    }
    else if (!volume.profileRef())
    {
        why << "it has no profile";
    }
    else if (std::ranges::none_of(volume.profileRef()->components(),
                                  [](const auto& component) { return component->active; }))
    {
        why << "no component of its profile is active";
    }
    else if (!InfluenceOf(volume, trigger))
    {
        const double distance = trigger ? std::sqrt(SquaredDistance(volume, *trigger)) : 0.0;
        if (!(volume.weight > 0.0f))
        {
            why << "its weight is " << volume.weight;
        }
        else if (std::isinf(distance))
        {
            why << "it is not global, and it has no collider that is on";
        }
        else if (!trigger)
        {
            why << "it is not global, and the camera has no point from which volumes are measured";
        }
        else
        {
            why << "the camera is " << std::setprecision(3) << distance
                << " m outside of its colliders, and it fades within " << volume.blendDistance
                << " m";
        }
    }
    return why.str();
}

} // namespace limn
