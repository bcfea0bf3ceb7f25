#pragma once

#include "device/Translate.h"
#include <limn/core/Texture.h>

namespace limn::vulkan
{

/// Makes mip levels 1, 2 ... of a colour, each from the one before by the device's linear filter.
/// @param image  all levels and layers of it were used as `before`, and are as `after` says then;
///               what levels but 0 held is gone
void RecordMips(VkCommandBuffer commands, VkImage image, const Texture& texture,
                const UsageScope& before, const UsageScope& after);

} // namespace limn::vulkan
