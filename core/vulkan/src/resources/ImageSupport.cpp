#include "resources/ImageSupport.h"

#include "device/Check.h"
#include "device/Translate.h"
#include <algorithm>
#include <bit>
#include <limn/core/DrawError.h>
#include <optional>

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

/// Returns the greatest image of that kind that the device makes; nullopt if it makes none.
std::optional<VkImageFormatProperties>
FindSupport(const VulkanContext& context, const VkImageCreateInfo& info, const Texture& texture)
{
    VkImageFormatProperties can{};
    const VkResult result = vkGetPhysicalDeviceImageFormatProperties(
        context.physicalDevice(), info.format, info.imageType, info.tiling, info.usage, info.flags,
        &can);
    if (result == VK_ERROR_FORMAT_NOT_SUPPORTED)
    {
        return std::nullopt;
    }
    Check(result, "vkGetPhysicalDeviceImageFormatProperties", texture.name());
    return can;
}

/// @param can  what the device makes of that kind
void RequireFits(const Texture& texture, const VkImageFormatProperties& can)
{
    const VkExtent3D extent = Extent(texture);
    const VkExtent3D& most = can.maxExtent;
    if (extent.width > most.width || extent.height > most.height || extent.depth > most.depth ||
        LayerCount(texture) > can.maxArrayLayers)
    {
        const bool isVolume = texture.dimension() == TextureDimension::Tex3D;
        throw DrawError("texture '" + texture.name() + "': it is " + texture.DescribeSize() +
                        "; the device makes at most " + std::to_string(most.width) + "x" +
                        std::to_string(most.height) + "x" +
                        std::to_string(isVolume ? most.depth : can.maxArrayLayers) +
                        " of that kind");
    }
}

/// Levels are made by blits.
void RequireMips(const VulkanContext& context, const VkImageCreateInfo& info,
                 const Texture& texture)
{
    constexpr VkFormatFeatureFlags k_Needed = VK_FORMAT_FEATURE_BLIT_SRC_BIT |
                                              VK_FORMAT_FEATURE_BLIT_DST_BIT |
                                              VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
    VkFormatProperties can{};
    vkGetPhysicalDeviceFormatProperties(context.physicalDevice(), info.format, &can);
    if (info.mipLevels > 1 && (can.optimalTilingFeatures & k_Needed) != k_Needed)
    {
        throw DrawError("texture '" + texture.name() + "': the device makes no mip levels of " +
                        limn::ToString(texture.graphicsFormat()));
    }
}

/// Returns the features that a usage requires of the format; 0 if limn has no such usage.
VkFormatFeatureFlags FeaturesFor(GraphicsFormat format, FormatUsage usage)
{
    const VkFormatFeatureFlags target = IsDepthFormat(format)
                                            ? VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT
                                            : VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT;
    switch (usage)
    {
    case FormatUsage::Sample:
        return VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
    case FormatUsage::Linear:
        return VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
    case FormatUsage::Render:
    case FormatUsage::MSAA2x:
    case FormatUsage::MSAA4x:
    case FormatUsage::MSAA8x:
        return target;
    case FormatUsage::Blend:
        return VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT;
    case FormatUsage::GetPixels:
    case FormatUsage::SetPixels:
    case FormatUsage::SetPixels32:
        return VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_TRANSFER_DST_BIT;
    case FormatUsage::ReadPixels:
        return target | VK_FORMAT_FEATURE_TRANSFER_SRC_BIT;
    case FormatUsage::LoadStore:
        return VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT;
    case FormatUsage::Sparse:
    case FormatUsage::StencilSampling:
        break;
    }
    return 0;
}

/// 1 where it is not about them.
int SamplesFor(FormatUsage usage)
{
    return usage == FormatUsage::MSAA2x   ? 2
           : usage == FormatUsage::MSAA4x ? 4
           : usage == FormatUsage::MSAA8x ? 8
                                          : 1;
}

/// "; R16G16B16A16_SFloat would do"
std::string InsteadOf(const Texture& texture)
{
    GraphicsFormatUsage usage = GraphicsFormatUsage::Sample;
    if (const auto* target = dynamic_cast<const RenderTexture*>(&texture))
    {
        usage = usage | GraphicsFormatUsage::Render;
        usage =
            target->descriptor().enableRandomWrite ? usage | GraphicsFormatUsage::LoadStore : usage;
    }
    const GraphicsFormat other = SystemInfo::GetCompatibleFormat(texture.graphicsFormat(), usage);
    return other == GraphicsFormat::None || other == texture.graphicsFormat()
               ? ""
               : std::string("; ") + limn::ToString(other) + " would do";
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
    static constexpr VkImageViewType k_Types[] = {
        VK_IMAGE_VIEW_TYPE_2D, VK_IMAGE_VIEW_TYPE_3D, VK_IMAGE_VIEW_TYPE_CUBE,
        VK_IMAGE_VIEW_TYPE_2D_ARRAY, VK_IMAGE_VIEW_TYPE_CUBE_ARRAY};
    return k_Types[static_cast<int>(dimension) - static_cast<int>(TextureDimension::Tex2D)];
}

VkImageCreateInfo Describe(const Texture& texture, std::uint32_t samples)
{
    auto info = Make<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
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

bool IsFormatSupported(const VulkanContext& context, GraphicsFormat format, FormatUsage usage)
{
    const VkFormatFeatureFlags needed = FeaturesFor(format, usage);
    if (format == GraphicsFormat::None || needed == 0)
    {
        return false;
    }
    VkFormatProperties can{};
    vkGetPhysicalDeviceFormatProperties(context.physicalDevice(), ToVkFormat(format), &can);
    if ((can.optimalTilingFeatures & needed) != needed)
    {
        return false;
    }
    const int samples = SamplesFor(usage);
    if (samples == 1)
    {
        return true;
    }
    RenderTextureDescriptor descriptor(4, 4, format);
    descriptor.msaaSamples = samples;
    return ComponentType(format) == UniformType::Float && // others cannot be resolved
           SupportedSampleCount(context, RenderTexture("", descriptor)) == samples;
}

int SupportedSampleCount(const VulkanContext& context, const RenderTexture& texture)
{
    const std::uint32_t most = SampleCount(texture);
    const VkImageCreateInfo info = Describe(texture, most);
    const auto can = FindSupport(context, info, texture);
    const VkSampleCountFlags counts = can ? can->sampleCounts : 0;
    return static_cast<int>(std::bit_floor(std::max(1U, counts & (most * 2U - 1U))));
}

void RequireSupport(const VulkanContext& context, const VkImageCreateInfo& info,
                    const Texture& texture)
{
    const std::string subject = "texture '" + texture.name() + "': ";
    if (texture.dimension() == TextureDimension::CubeArray &&
        !context.capabilities().features.imageCubeArray)
    {
        throw DrawError(subject + "the device has no arrays of cubes");
    }
    const auto can = FindSupport(context, info, texture);
    if (!can)
    {
        throw DrawError(subject + "the device cannot use format " +
                        limn::ToString(texture.graphicsFormat()) + " for it" + InsteadOf(texture));
    }
    RequireFits(texture, *can);
    RequireMips(context, info, texture);
    if ((can->sampleCounts & static_cast<VkSampleCountFlags>(info.samples)) == 0)
    {
        throw DrawError(subject + "the device does not support " +
                        std::to_string(static_cast<int>(info.samples)) + " samples of " +
                        limn::ToString(texture.graphicsFormat()));
    }
}

} // namespace limn::vulkan
