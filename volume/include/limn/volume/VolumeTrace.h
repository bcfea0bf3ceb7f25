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

/// The history of one component of a stack: every step of its blending, kept so that it can be
/// repeated. Unity has no counterpart.
struct VolumeComponentTrace
{
    /// A component of a volume and how far the state moved towards it.
    struct Step
    {
        std::shared_ptr<const VolumeComponent> target; ///< a copy
        float factor = 0.0f;                           ///< 0...1
    };

    std::string component;                        ///< its type in files: "ScreenSpaceOutline"
    std::shared_ptr<const VolumeComponent> start; ///< a component with the values of the defaults
    std::vector<Step> steps;                      ///< in the order they were applied
    std::function<std::unique_ptr<VolumeComponent>()> create; ///< a new one of its type

    /// Returns a component with exactly the bits that VolumeManager::Update gives: it applies
    /// VolumeComponent::Override of every step to the start, also where a subclass overrides
    /// Override.
    std::unique_ptr<VolumeComponent> Replay() const;
};

/// One volume's part in a blended value.
struct VolumeTraceStep
{
    std::string volume; ///< its name
    /// 0...1: weight times fade, the part of the way to the target that the value moved.
    float factor = 0.0f;
    float weight = 0.0f;           ///< 0...1
    std::optional<float> distance; ///< metres to the closest collider; nullopt for a global volume
    std::string targetText;        ///< the volume's value, as VolumeParameter::ValueText
    std::string valueText;         ///< the value after this step
    std::shared_ptr<const VolumeComponent> target; ///< a copy of the volume's component
};

/// The history of one parameter's value.
struct VolumeParameterTrace
{
    std::string component;              ///< its type in files: "ScreenSpaceOutline"
    std::string parameter;              ///< serialised name: "m_OutlineWidth"
    std::size_t index = 0;              ///< index of the parameter in its component
    std::string startText;              ///< the default value that the first step started from
    std::vector<VolumeTraceStep> steps; ///< in the order they were applied; never empty
    std::shared_ptr<const VolumeComponentTrace> whole; ///< the history of its component

    const std::string& valueText() const { return steps.back().valueText; }

    /// Repeats every step of the component and sets `value` to the result, which has exactly the
    /// bits that VolumeManager::Update gives.
    /// @throws ContractError if it holds another type of value
    void Replay(VolumeParameter& value) const;
};

/// The origin of the values of a stack. It has every parameter that a volume overrides or, where a
/// component overrides VolumeComponent::Override, changes, in the order of registration of the
/// components. It keeps what it refers to alive. Unity has no counterpart.
struct VolumeTrace
{
    std::vector<VolumeParameterTrace> parameters;

    /// Returns the history of a parameter, or null if no volume overrides it.
    /// @param parameter  its serialised name
    const VolumeParameterTrace* Find(std::string_view component, std::string_view parameter) const;
};

/// Returns why a volume has no effect on a camera, or "" if it has one. The result is a clause that
/// can follow the volume's name: "the camera is 21 m outside of its colliders, and it fades within
/// 4 m". The rules are those of VolumeManager::Update. Unity has no counterpart.
/// @param trigger, layerMask  as for VolumeManager::Update
std::string WhyIdle(const Volume& volume, const std::optional<glm::vec3>& trigger,
                    LayerMask layerMask);

} // namespace limn
