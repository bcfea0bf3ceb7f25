#pragma once

#include "console/Console.h"

#include <string>

namespace limn
{

/// Says what limn finds on this machine.
/// @param device  which device is asked for, as VulkanDeviceOptions::device
/// @return an ExitCode: MachineLacksIt if no device can be used
int RunDoctor(const std::string& device, Console& console);

} // namespace limn
