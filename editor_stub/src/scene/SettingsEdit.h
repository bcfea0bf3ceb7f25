#pragma once

#include <limn/editor_stub/AssetContext.h>
#include <limn/volume/ProfileEdit.h>

namespace limn
{

/// Gives settings of a scene's or of a Unity renderer's features new values, in place, as
/// SetScalars does for the parameters of a profile. The name in a path is a feature's name or, if
/// no feature has it, a feature type, whose features are then all changed.
/// @param written  if given, it receives the file's text before and after
/// @return what each edit did
/// @throws AssetError with every problem: an unknown name, a value of the wrong type or outside its
///     range, a setting that a file of Unity's does not have, and any other problem of the file,
///     which then stays as it was
std::vector<ScalarChange> SetFeatureSettings(const std::filesystem::path& path,
                                             std::span<const ValueAssignment> edits,
                                             AssetContext& assets, FileEdit* written = nullptr);

} // namespace limn
