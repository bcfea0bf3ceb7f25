#pragma once

#include <limn/editor_stub/SceneFile.h>
#include <span>
#include <string>

namespace limn
{

/// Changes single values of a loaded scene, each given as "NAME.path=value"; see ValuePath. NAME is
/// the type of a volume component (the value then holds everywhere, whatever the scene's volumes
/// say), the name of a feature, or the type of features. The path leads to a parameter or a setting
/// as it does in a file, or is a feature's `active`. The value is YAML. Files that a value names
/// are looked for in the working directory, then in the scene's folder.
/// @throws AssetError with every problem of all overrides
void ApplyOverrides(SceneAsset& asset, std::span<const std::string> overrides,
                    AssetContext& assets);

/// Puts one profile in place of the profiles of all global volumes. A scene without a global volume
/// gets one, in a layer that the camera's volumeLayerMask has. `file` is looked for in the working
/// directory, then in the scene's folder.
/// @throws AssetError as LoadVolumeProfile, and if the camera's volumeLayerMask is Nothing
void ReplaceProfile(SceneAsset& asset, const std::string& file, AssetContext& assets);

} // namespace limn
