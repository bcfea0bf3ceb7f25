#pragma once

#include <limn/volume/VolumeComponentRegistry.h>
#include <limn/volume/VolumeProfile.h>
#include <string>

namespace limn
{

/// The two forms a profile's YAML comes in.
enum class YamlForm
{
    Limn, ///< component, parameter, value; only what is overridden
    Unity ///< a VolumeProfile asset; every parameter with m_OverrideState and m_Value
};

/// The text of a profile file, which LoadVolumeProfile reads back to the same overrides and
/// values. limn's form leaves out the profile's name, which is the file's. Unity's gives every
/// component a fileID that depends on its type alone, and refers to no script, since only Unity
/// knows its guid.
/// @throws ContractError if the registry lacks the type of a component
std::string WriteVolumeProfile(const VolumeProfile& profile,
                               const VolumeComponentRegistry& registry, YamlForm form);

} // namespace limn
