#pragma once

#include <glm/vec3.hpp>
#include <limn/volume/Volume.h>
#include <optional>
#include <span>
#include <utility>

namespace limn
{

/// The influence of a volume on the trigger.
struct VolumeInfluence
{
    float factor;                          ///< 0...1, the fade times the weight
    float weight;                          ///< 0...1
    std::optional<double> squaredDistance; ///< to the closest collider; nullopt for a global volume
};

/// Returns the influence of a volume, or nullopt if it does not take part at all. A volume with
/// factor 0 takes part: it still marks its parameters as overridden.
std::optional<VolumeInfluence> InfluenceOf(const Volume& volume,
                                           const std::optional<glm::vec3>& trigger);

/// Calls visit(volume, component, influence) for every contribution to the blend, in the order in
/// which they are applied. No other code knows the rules of blending.
/// @param sorted  the volumes by ascending priority
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
