#pragma once

#include "console/Console.h"
#include "explain/InspectReport.h"

#include <limn/editor_stub/AssetContext.h>

namespace limn
{

/// A profile's file without a scene, so that any name may be a layer's: a value with a name that
/// only a scene can know is shown as the file has it, with a note.
/// @param documents  the file's; one Null for a Unity asset
/// @throws AssetError as LoadVolumeProfile
std::vector<InspectedGroup> InspectProfileFile(const std::filesystem::path& path,
                                               const std::vector<YamlNode>& documents,
                                               AssetContext& assets, Console& console);

} // namespace limn
