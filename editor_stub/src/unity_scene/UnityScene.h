#pragma once

#include <limn/editor_stub/SceneFile.h>

namespace limn
{

/// Returns the scene that a project starts with: the first one that its build settings enable, or
/// its only one.
/// @param project  the folder that has Assets and ProjectSettings
/// @throws AssetError  if there is none, or if there are several and none is enabled, with their
///     paths
std::filesystem::path FindFirstUnityScene(const std::filesystem::path& project);

/// Loads a scene of a Unity project, with its prefabs, models, materials, volumes, lights and main
/// camera, and the renderer of its quality level. Things that limn does not draw become notes.
/// It sets the colour space of the process. Unity: the text form of 2018.3 to 6000.
/// @throws AssetError  if the scene cannot be read, or has no camera
SceneAsset LoadUnityScene(const std::filesystem::path& path, AssetContext& assets);

} // namespace limn
