#pragma once

#include "device/Translate.h"
#include <limn/core/Texture.h>

namespace limn::vulkan
{

/// Makes mip levels 1, 2 ... of a colour texture, each from the level before by the device's linear
/// filter.
/// @param image  all its levels and layers change from the use `before` to the use `after`; all
///     levels but 0 lose their content
void RecordMips(VkCommandBuffer commands, VkImage image, const Texture& texture,
                const UsageScope& before, const UsageScope& after);

} // namespace limn::vulkan
