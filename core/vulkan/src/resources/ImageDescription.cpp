#include "resources/ImageDescription.h"

#include "device/Translate.h"
#include <algorithm>

namespace limn::vulkan
{

namespace
{

/// Several samples are drawn into and resolved only.
VkImageUsageFlags UsageFlags(const Texture& texture, std::uint32_t samples)
{
    const auto* target = dynamic_cast<const RenderTexture*>(&texture);
    if (target == nullptr)
    {
        return VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
               (texture.mipmapCount() > 1 ? VK_IMAGE_USAGE_TRANSFER_SRC_BIT : 0);
    }
    const VkImageUsageFlags attachment = IsDepthFormat(texture.graphicsFormat())
                                             ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                             : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    const VkImageUsageFlags made =
        texture.mipmapCount() > 1 ? VK_IMAGE_USAGE_TRANSFER_DST_BIT : 0; // from level to level
    const VkImageUsageFlags written =
        target->descriptor().enableRandomWrite ? VK_IMAGE_USAGE_STORAGE_BIT : 0;
    return samples == 1 ? attachment | made | written | VK_IMAGE_USAGE_SAMPLED_BIT |
                              VK_IMAGE_USAGE_TRANSFER_SRC_BIT
           : target->isTransient() ? attachment | VK_IMAGE_USAGE_TRANSIENT_ATTACHMENT_BIT
                                   : attachment;
}

bool isCube(const Texture& texture)
{
    return texture.dimension() == TextureDimension::Cube ||
           texture.dimension() == TextureDimension::CubeArray;
}

} // namespace

std::uint32_t SampleCount(const Texture& texture)
{
    const auto* target = dynamic_cast<const RenderTexture*>(&texture);
    return target == nullptr ? 1 : static_cast<std::uint32_t>(target->descriptor().msaaSamples);
}

VkImageAspectFlags Aspects(GraphicsFormat format)
{
    if (!IsDepthFormat(format))
    {
        return VK_IMAGE_ASPECT_COLOR_BIT;
    }
    return HasStencil(format) ? VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT
                              : VK_IMAGE_ASPECT_DEPTH_BIT;
}

VkExtent3D Extent(const Texture& texture, std::uint32_t level)
{
    const bool isVolume = texture.dimension() == TextureDimension::Tex3D;
    const auto halved = [level](int size)
    {
        return std::max(static_cast<std::uint32_t>(size) >> level, 1U);
    };
    return {halved(texture.width()), halved(texture.height()),
            isVolume ? halved(texture.slices()) : 1};
}

std::uint32_t LayerCount(const Texture& texture)
{
    const bool isVolume = texture.dimension() == TextureDimension::Tex3D;
    return isVolume ? 1 : static_cast<std::uint32_t>(texture.slices());
}

VkImageViewType ViewType(TextureDimension dimension)
{
    switch (dimension)
    {
    case TextureDimension::Tex3D:
        return VK_IMAGE_VIEW_TYPE_3D;
    case TextureDimension::Cube:
        return VK_IMAGE_VIEW_TYPE_CUBE;
    case TextureDimension::Tex2DArray:
        return VK_IMAGE_VIEW_TYPE_2D_ARRAY;
    case TextureDimension::CubeArray:
        return VK_IMAGE_VIEW_TYPE_CUBE_ARRAY;
    case TextureDimension::Tex2D:
        break;
    }
    return VK_IMAGE_VIEW_TYPE_2D;
}

VkImageCreateInfo Describe(const Texture& texture, std::uint32_t samples)
{
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    if (isCube(texture))
    {
        info.flags = VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT;
    }
    info.imageType =
        texture.dimension() == TextureDimension::Tex3D ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D;
    info.format = ToVkFormat(texture.graphicsFormat());
    info.extent = Extent(texture);
    info.mipLevels = samples == 1 ? static_cast<std::uint32_t>(texture.mipmapCount()) : 1;
    info.arrayLayers = LayerCount(texture);
    info.samples = static_cast<VkSampleCountFlagBits>(samples);
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = UsageFlags(texture, samples);
    return info;
}

} // namespace limn::vulkan
