#pragma once

#include "Console.h"

#include <string>

namespace limn
{

/// Prints the JSON Schema (draft 2020-12) of one kind of file.
/// @param kind  "scene" or "profile"
/// @return an ExitCode
int RunSchema(const std::string& kind, Console& console);

} // namespace limn
