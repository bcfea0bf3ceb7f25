#pragma once

#include <limn/volume/VolumeComponentRegistry.h>

namespace limn
{

/// Returns a component with the same type, values and override states that shares nothing with the
/// given one.
/// @throws ContractError if the registry lacks the type
std::unique_ptr<VolumeComponent> CloneComponent(const VolumeComponent& component,
                                                const VolumeComponentRegistry& registry);

/// Calls VolumeComponent::Override, which the component's class may override.
void OverrideState(const VolumeComponent& component, VolumeComponent& state, float interpFactor);

/// Copies the values and override states of all parameters; both components must be of one type.
void CopyParameters(const VolumeComponent& from, VolumeComponent& to);

} // namespace limn
