#pragma once

#include "console/Console.h"
#include "view/RenderOptions.h"

namespace limn
{

/// Draws the scene into a PNG.
/// @return an ExitCode: BadInput if a validation layer reported errors
/// @throws AssetError, VulkanError; nothing is then written
int RunRender(const RenderOptions& options, Console& console);

} // namespace limn
