#pragma once

#include "device/VulkanContext.h"
#include <limn/core/RenderTexture.h>
#include <limn/core/SystemInfo.h>

namespace limn::vulkan
{

/// Returns the number of samples per texel that the device supports for the texture, at most as
/// many as the texture has.
int SupportedSampleCount(const VulkanContext& context, const RenderTexture& texture);

bool IsFormatSupported(const VulkanContext& context, GraphicsFormat format, FormatUsage usage);

/// @throws DrawError with the name of the texture, if the device supports no image of its
///     dimension, format, size, samples or mip levels
void RequireSupport(const VulkanContext& context, const VkImageCreateInfo& info,
                    const Texture& texture);

} // namespace limn::vulkan
