#pragma once

#include <limn/volume/AssetDiagnostics.h>
#include <limn/volume/ProfileContext.h>
#include <limn/volume/UnityAsset.h>
#include <limn/volume/VolumeComponentRegistry.h>
#include <limn/volume/VolumeProfile.h>
#include <memory>

namespace limn
{

/// The VolumeProfile in a Unity asset. What Unity has and the registry does not becomes a note,
/// what is wrong with a known parameter an error. A component is known by its m_Name.
std::shared_ptr<VolumeProfile> ReadUnityVolumeProfile(const UnityAsset& asset,
                                                      const VolumeComponentRegistry& registry,
                                                      AssetDiagnostics& diagnostics,
                                                      const ProfileContext& context);

} // namespace limn
