#pragma once

#include "console/Console.h"

#include <string>

namespace limn
{

/// Prints the JSON Schema (draft 2020-12) of one kind of file.
/// @param kind  "scene", "profile" or "material"
/// @return an ExitCode
int RunSchema(const std::string& kind, Console& console);

} // namespace limn
