#pragma once

#include "commands/RenderCommand.h"

namespace limn
{

/// Draws the scene into a PNG, and again whenever a file that it reaches changes, until SIGINT or
/// SIGTERM. What is wrong with a file is printed and the last good picture stays. `frames`, `stats`
/// and `trace` of the options play no role.
/// @return ExitCode::Done
/// @throws AssetError if the scene file or the output's folder is missing when it starts
/// @throws VulkanError
int RunWatch(const RenderOptions& options, Console& console);

} // namespace limn
