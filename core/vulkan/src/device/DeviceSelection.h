#pragma once

#include <limn/vulkan/VulkanDevice.h>
#include <optional>
#include <string_view>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

struct DeviceChoice
{
    std::size_t index = 0; ///< into the list that was chosen from
    std::string sentence;  ///< which device and why
};

/// Picks the device that VulkanDeviceOptions::device asks for.
/// @throws VulkanError that says for each device why it was not taken
DeviceChoice ChooseDevice(const std::vector<VulkanDeviceInfo>& devices, std::string_view request);

VulkanDeviceInfo DescribeDevice(VkPhysicalDevice device);

/// The first queue family that draws.
std::optional<std::uint32_t> GraphicsQueueFamily(VkPhysicalDevice device);

} // namespace limn::vulkan
