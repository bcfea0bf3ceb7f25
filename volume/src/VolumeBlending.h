#pragma once

#include <glm/vec3.hpp>
#include <limn/volume/Volume.h>
#include <optional>
#include <span>
#include <utility>

namespace limn
{

/// How much of a volume counts, 0...1, seen from the trigger; nothing if it does not take part at
/// all. 0 is not nothing: such a volume still marks its parameters as overridden.
std::optional<float> BlendFactor(const Volume& volume, const std::optional<glm::vec3>& trigger);

/// Calls visit(volume, component, factor) for every contribution to the blend, in the order in
/// which they are applied. The one place that knows the rules, whoever the visitor is.
/// @param sorted  by ascending priority
template <typename Visitor>
void ForEachContribution(std::span<const Volume* const> sorted,
                         const std::optional<glm::vec3>& trigger, Visitor&& visit)
{
    for (const Volume* volume : sorted)
    {
        const std::optional<float> factor = BlendFactor(*volume, trigger);
        if (!factor)
        {
            continue;
        }
        for (const std::unique_ptr<VolumeComponent>& component :
             volume->sharedProfile->components())
        {
            if (component->active)
            {
                visit(*volume, std::as_const(*component), *factor);
            }
        }
    }
}

} // namespace limn
