#pragma once

#include "device/VulkanContext.h"
#include <limn/core/RenderTexture.h>
#include <limn/core/SystemInfo.h>

namespace limn::vulkan
{

// Describes textures to Vulkan.

/// Returns the samples per texel, which is 1 except for render textures.
std::uint32_t SampleCount(const Texture& texture);
VkImageAspectFlags Aspects(GraphicsFormat format);
/// Returns the size of a mip level in texels. The slices of a 3D texture are its depth.
VkExtent3D Extent(const Texture& texture, std::uint32_t level = 0);
/// Returns the number of layers, which are the slices of every texture that is not 3D.
std::uint32_t LayerCount(const Texture& texture);
VkImageViewType ViewType(TextureDimension dimension);

/// @param samples  an image with several is only drawn into and resolved
VkImageCreateInfo Describe(const Texture& texture, std::uint32_t samples);

/// Returns the number of samples per texel that the device supports for the texture, at most as
/// many as the texture has.
int SupportedSampleCount(const VulkanContext& context, const RenderTexture& texture);

bool IsFormatSupported(const VulkanContext& context, GraphicsFormat format, FormatUsage usage);

/// @throws DrawError with the name of the texture, if the device supports no image of its
///     dimension, format, size, samples or mip levels
void RequireSupport(const VulkanContext& context, const VkImageCreateInfo& info,
                    const Texture& texture);

} // namespace limn::vulkan
