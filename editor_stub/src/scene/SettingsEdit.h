#pragma once

#include <limn/editor_stub/AssetContext.h>
#include <limn/volume/ProfileEdit.h>

namespace limn
{

/// Gives settings of a scene's or of a Unity renderer's features new values, in place, as
/// SetScalars does for the parameters of a profile. The name of a path is a feature's name or, if
/// none has it, a type of features, all of which are then changed.
/// @param written  if given, it receives the file's text before and after
/// @return what each edit did
/// @throws AssetError with every problem: an unknown name, a value of the wrong type or outside its
///     range, a setting that a file of Unity's does not have, and whatever else is wrong with the
///     file, which is then as it was
std::vector<ScalarChange> SetFeatureSettings(const std::filesystem::path& path,
                                             std::span<const ValueAssignment> edits,
                                             AssetContext& assets, FileEdit* written = nullptr);

} // namespace limn
