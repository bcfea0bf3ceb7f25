#pragma once

#include <limn/volume/AssetDiagnostics.h>
#include <limn/volume/ProfileContext.h>
#include <limn/volume/UnityAsset.h>
#include <limn/volume/VolumeComponentRegistry.h>
#include <limn/volume/VolumeProfile.h>
#include <memory>

namespace limn
{

/// Reads the VolumeProfile of a Unity asset. Components and parameters that the registry does not
/// know become notes; a problem with a known parameter is an error. A component is recognised by
/// its m_Name.
std::shared_ptr<VolumeProfile> ReadUnityVolumeProfile(const UnityAsset& asset,
                                                      const VolumeComponentRegistry& registry,
                                                      AssetDiagnostics& diagnostics,
                                                      const ProfileContext& context);

} // namespace limn
