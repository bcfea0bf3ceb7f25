#pragma once

#include <limn/vulkan/VulkanDevice.h>
#include <optional>
#include <string_view>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

struct DeviceChoice
{
    std::size_t index = 0; ///< its index in the list of devices
    std::string sentence;  ///< names the chosen device and the reason
};

/// Picks the device that VulkanDeviceOptions::device asks for.
/// @throws VulkanError with the reason why each device was not chosen
DeviceChoice ChooseDevice(const std::vector<VulkanDeviceInfo>& devices, std::string_view request);

VulkanDeviceInfo DescribeDevice(VkPhysicalDevice device);

/// Returns one of the structures that extend VkPhysicalDeviceProperties2.
template <typename Properties>
Properties ReadProperties(VkPhysicalDevice device, VkStructureType type)
{
    Properties chained{};
    chained.sType = type;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &chained;
    vkGetPhysicalDeviceProperties2(device, &properties);
    return chained;
}

std::vector<VkQueueFamilyProperties> QueueFamilies(VkPhysicalDevice device);
/// Returns the first queue family that can draw.
std::optional<std::uint32_t> GraphicsQueueFamily(VkPhysicalDevice device);

} // namespace limn::vulkan
