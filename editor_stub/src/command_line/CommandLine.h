#pragma once

#include "console/Console.h"

#include <limn/editor_stub/RunLimn.h>
#include <span>
#include <string>

namespace limn
{

/// Parses the arguments and runs the verb; errors come as exceptions.
ExitCode RunCommandLine(std::span<const std::string> args, Console& console);

} // namespace limn
