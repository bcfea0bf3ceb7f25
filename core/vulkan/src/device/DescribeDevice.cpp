#include "device/Check.h"
#include "device/DeviceFeatures.h"
#include "device/DeviceSelection.h"

namespace limn::vulkan
{

namespace
{

VulkanDeviceType ToDeviceType(VkPhysicalDeviceType type)
{
    switch (type)
    {
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return VulkanDeviceType::IntegratedGpu;
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return VulkanDeviceType::DiscreteGpu;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return VulkanDeviceType::VirtualGpu;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        return VulkanDeviceType::Software;
    default:
        return VulkanDeviceType::Other;
    }
}

std::string VersionText(std::uint32_t version)
{
    return std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
           std::to_string(VK_API_VERSION_MINOR(version)) + "." +
           std::to_string(VK_API_VERSION_PATCH(version));
}

} // namespace

std::optional<std::uint32_t> GraphicsQueueFamily(VkPhysicalDevice device)
{
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    // Vulkan promises one that does both where one draws.
    for (const VkQueueFlags wanted : {VkQueueFlags{VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT},
                                      VkQueueFlags{VK_QUEUE_GRAPHICS_BIT}})
    {
        for (std::uint32_t i = 0; i < count; ++i)
        {
            if ((families[i].queueFlags & wanted) == wanted)
            {
                return i;
            }
        }
    }
    return std::nullopt;
}

VulkanDeviceInfo DescribeDevice(VkPhysicalDevice device)
{
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &driver;
    vkGetPhysicalDeviceProperties2(device, &properties);

    VulkanDeviceInfo info;
    info.name = properties.properties.deviceName;
    info.type = ToDeviceType(properties.properties.deviceType);
    info.apiVersion = VersionText(properties.properties.apiVersion);
    info.driverName = driver.driverName;
    info.driverInfo = driver.driverInfo;
    const VkPhysicalDeviceLimits& limits = properties.properties.limits;
    info.subPixelPrecisionBits = static_cast<int>(limits.subPixelPrecisionBits);
    if (properties.properties.apiVersion < VK_API_VERSION_1_3)
    {
        // Its 1.3 features cannot even be asked for.
        info.problems.push_back("it supports Vulkan " + info.apiVersion + ", but limn needs 1.3");
        return info;
    }
    const OptionalExtensions extensions = FindExtensions(device);
    FeatureChain offered{extensions};
    vkGetPhysicalDeviceFeatures2(device, &offered.core);
    info.problems = MissingFeatures(offered);
    info.lacks = Lacks(offered, extensions, limits);
    if (!GraphicsQueueFamily(device))
    {
        info.problems.push_back("it has no queue that draws");
    }
    return info;
}

} // namespace limn::vulkan
