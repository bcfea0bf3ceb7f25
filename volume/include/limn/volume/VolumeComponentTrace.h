#pragma once

#include <functional>
#include <limn/volume/VolumeComponent.h>
#include <memory>
#include <string>
#include <vector>

namespace limn
{

/// How one component of a stack came to its values: everything that blending did to it, kept so
/// that it can be done again. No counterpart in Unity.
struct VolumeComponentTrace
{
    /// A component of a volume and how far the state moved towards it.
    struct Step
    {
        std::shared_ptr<const VolumeComponent> target; ///< a copy
        float factor = 0.0f;                           ///< 0...1
    };

    std::string component;                        ///< as files call its type: "ScreenSpaceOutline"
    std::shared_ptr<const VolumeComponent> start; ///< with the values of the defaults
    std::vector<Step> steps;                      ///< in the order they were applied
    std::function<std::unique_ptr<VolumeComponent>()> create; ///< a new one of its type

    /// A component with the very bits that VolumeManager::Update gives: the start with
    /// VolumeComponent::Override of every step, one that a subclass overrides included.
    std::unique_ptr<VolumeComponent> Replay() const;
};

} // namespace limn
