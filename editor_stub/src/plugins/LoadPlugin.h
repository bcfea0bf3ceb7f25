#pragma once

#include <filesystem>
#include <limn/features/FeatureRegistry.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn
{

/// Loads a plug-in, registers what it holds and adds its shaders to ShippedShaders(). It stays
/// loaded until the process ends, since whoever got an object of it runs its code; its code is read
/// once, however often it is asked for. From then on what its features and passes throw in a frame
/// is an AssetError that names it, but for AssetErrors, lack of memory and failures of the driver.
/// @throws AssetError if there is no such file, it is no library, no plug-in, one for another limn,
///     or a name of it is taken
void LoadPlugin(const std::filesystem::path& path, FeatureRegistry& features,
                VolumeComponentRegistry& components);

} // namespace limn
