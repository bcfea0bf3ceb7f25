#pragma once

#include "console/Console.h"

#include <span>
#include <string>

namespace limn
{

/// Prints the JSON Schema (draft 2020-12) of one kind of file.
/// @param kind     "scene", "profile" or "material"
/// @param plugins  modules whose features and components are in it
/// @return an ExitCode
/// @throws AssetError if a plug-in cannot be used
int RunSchema(const std::string& kind, std::span<const std::string> plugins, Console& console);

} // namespace limn
