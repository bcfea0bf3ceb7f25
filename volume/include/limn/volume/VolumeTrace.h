#pragma once

#include <functional>
#include <limn/core/LayerMask.h>
#include <limn/volume/Volume.h>
#include <limn/volume/VolumeComponent.h>
#include <memory>
#include <optional>
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

/// One volume's part in a blended value.
struct VolumeTraceStep
{
    std::string volume;  ///< its name
    float factor = 0.0f; ///< 0...1: weight times fade, how far the value moved to the target
    float weight = 0.0f; ///< 0...1
    std::optional<float> distance; ///< metres to the closest collider; nothing: a global volume
    std::string targetText;        ///< the volume's value, as VolumeParameter::ValueText
    std::string valueText;         ///< what the value was then
    std::shared_ptr<const VolumeComponent> target; ///< a copy of the volume's component
};

/// How one parameter came to its value.
struct VolumeParameterTrace
{
    std::string component;              ///< as files call its type: "ScreenSpaceOutline"
    std::string parameter;              ///< serialised name: "m_OutlineWidth"
    std::size_t index = 0;              ///< of the parameter in its component
    std::string startText;              ///< the default value that the first step started from
    std::vector<VolumeTraceStep> steps; ///< in the order they were applied; never empty
    std::shared_ptr<const VolumeComponentTrace> whole; ///< of the component it belongs to

    const std::string& valueText() const { return steps.back().valueText; }

    /// Sets `value` to what taking every step of the component again gives: the very bits that
    /// VolumeManager::Update gives.
    /// @throws ContractError if it holds another type of value
    void Replay(VolumeParameter& value) const;
};

/// Where the values of a stack come from: every parameter that a volume overrides or, where a
/// component overrides VolumeComponent::Override, changes; in the order of registration of the
/// components. Keeps what it refers to. No counterpart in Unity.
struct VolumeTrace
{
    std::vector<VolumeParameterTrace> parameters;

    /// Null for a parameter that no volume overrides. @param parameter  its serialised name
    const VolumeParameterTrace* Find(std::string_view component, std::string_view parameter) const;
};

/// Why a volume has no part in what a camera takes; "" if it has one. A phrase behind the volume's
/// name: "the camera is 21 m outside of its colliders, and it fades within 4 m". The rules are
/// those of VolumeManager::Update. No counterpart in Unity.
/// @param trigger, layerMask  as for VolumeManager::Update
std::string WhyIdle(const Volume& volume, const std::optional<glm::vec3>& trigger,
                    LayerMask layerMask);

} // namespace limn
