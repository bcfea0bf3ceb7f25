#pragma once

#include "device/VulkanContext.h"
#include <limn/core/RenderTexture.h>
#include <limn/core/SystemInfo.h>

namespace limn::vulkan
{

/// The samples a texel that the device does of the texture: at most as many as it has.
int SupportedSampleCount(const VulkanContext& context, const RenderTexture& texture);

bool IsFormatSupported(const VulkanContext& context, GraphicsFormat format, FormatUsage usage);

/// @throws DrawError naming the texture, if the device makes no such image: of its dimension,
///         format, size, samples or mip levels
void RequireSupport(const VulkanContext& context, const VkImageCreateInfo& info,
                    const Texture& texture);

} // namespace limn::vulkan
