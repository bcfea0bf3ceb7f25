#pragma once

#include <limn/core/RenderTexture.h>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

// What textures are to Vulkan.

/// Of a texel; 1 but for render textures.
std::uint32_t SampleCount(const Texture& texture);
VkImageAspectFlags Aspects(GraphicsFormat format);
/// Returns the texels of a mip level. A 3D texture's slices are its depth.
VkExtent3D Extent(const Texture& texture, std::uint32_t level = 0);
/// Every other texture's slices are layers.
std::uint32_t LayerCount(const Texture& texture);
VkImageViewType ViewType(TextureDimension dimension);

/// @param samples  several are drawn into and resolved only
VkImageCreateInfo Describe(const Texture& texture, std::uint32_t samples);

} // namespace limn::vulkan
