#pragma once

#include "console/Console.h"

#include <span>
#include <string>

namespace limn
{

/// Parses the arguments and runs the verb; errors come as exceptions.
/// @return an ExitCode
int RunCommandLine(std::span<const std::string> args, Console& console);

} // namespace limn
