#pragma once

#include <glm/vec3.hpp>
#include <limn/volume/Volume.h>
#include <optional>
#include <span>
#include <utility>

namespace limn
{

/// How much a volume counts, seen from the trigger.
struct VolumeInfluence
{
    float factor;                          ///< 0...1, the fade times the weight
    float weight;                          ///< 0...1
    std::optional<double> squaredDistance; ///< to the closest collider; nothing: it is global
};

/// Nothing if the volume does not take part at all. A factor of 0 is not nothing: such a volume
/// still marks its parameters as overridden.
std::optional<VolumeInfluence> InfluenceOf(const Volume& volume,
                                           const std::optional<glm::vec3>& trigger);

/// Calls visit(volume, component, influence) for every contribution to the blend, in the order in
/// which they are applied. The one place that knows the rules, whoever the visitor is.
/// @param sorted  by ascending priority
template <typename Visitor>
void ForEachContribution(std::span<const Volume* const> sorted,
                         const std::optional<glm::vec3>& trigger, Visitor&& visit)
{
    for (const Volume* volume : sorted)
    {
        const std::optional<VolumeInfluence> influence = InfluenceOf(*volume, trigger);
        if (!influence)
        {
            continue;
        }
        for (const std::unique_ptr<VolumeComponent>& component : volume->profileRef()->components())
        {
            if (component->active)
            {
                visit(*volume, std::as_const(*component), *influence);
            }
        }
    }
}

} // namespace limn
