#pragma once

#include <limn/core/RenderTexture.h>
#include <vulkan/vulkan.h>

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

} // namespace limn::vulkan
