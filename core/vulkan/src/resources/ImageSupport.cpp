#include "resources/ImageSupport.h"

#include "device/Check.h"
#include "resources/ImageDescription.h"
#include <algorithm>
#include <bit>

namespace limn::vulkan
{

namespace
{

/// @param can  what the device makes of that kind
void RequireFits(const Texture& texture, const VkImageFormatProperties& can)
{
    const VkExtent3D extent = Extent(texture);
    const VkExtent3D& most = can.maxExtent;
    if (extent.width > most.width || extent.height > most.height || extent.depth > most.depth ||
        LayerCount(texture) > can.maxArrayLayers)
    {
        const bool isVolume = texture.dimension() == TextureDimension::Tex3D;
        throw ContractError("texture '" + texture.name() + "': it is " + texture.DescribeSize() +
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
        throw ContractError("texture '" + texture.name() + "': the device makes no mip levels of " +
                            limn::ToString(texture.graphicsFormat()));
    }
}

} // namespace

int SupportedSampleCount(const VulkanContext& context, const RenderTexture& texture)
{
    const std::uint32_t most = SampleCount(texture);
    const VkImageCreateInfo info = Describe(texture, most);
    VkImageFormatProperties can{};
    const VkResult result = vkGetPhysicalDeviceImageFormatProperties(
        context.physicalDevice(), info.format, info.imageType, info.tiling, info.usage, info.flags,
        &can);
    const VkSampleCountFlags counts = result == VK_SUCCESS ? can.sampleCounts : 0;
    return static_cast<int>(std::bit_floor(std::max(1U, counts & (most * 2U - 1U))));
}

void RequireSupport(const VulkanContext& context, const VkImageCreateInfo& info,
                    const Texture& texture)
{
    const std::string subject = "texture '" + texture.name() + "': ";
    if (texture.dimension() == TextureDimension::CubeArray && !context.capabilities().cubeArray)
    {
        throw ContractError(subject + "the device has no arrays of cubes");
    }
    VkImageFormatProperties can{};
    const VkResult result = vkGetPhysicalDeviceImageFormatProperties(
        context.physicalDevice(), info.format, info.imageType, info.tiling, info.usage, info.flags,
        &can);
    if (result == VK_ERROR_FORMAT_NOT_SUPPORTED)
    {
        throw ContractError(subject + "the device cannot use format " +
                            limn::ToString(texture.graphicsFormat()) + " for it");
    }
    Check(result, "vkGetPhysicalDeviceImageFormatProperties", texture.name());
    RequireFits(texture, can);
    RequireMips(context, info, texture);
    if ((can.sampleCounts & static_cast<VkSampleCountFlags>(info.samples)) == 0)
    {
        throw ContractError(subject + "the device does not do " +
                            std::to_string(static_cast<int>(info.samples)) + " samples of " +
                            limn::ToString(texture.graphicsFormat()));
    }
}

} // namespace limn::vulkan
