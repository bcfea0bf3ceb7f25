#include "device/DeviceSelection.h"

#include "device/DeviceFeatures.h"
#include "device/VulkanInstance.h"
#include <functional>
#include <limn/base/Case.h>
#include <limn/base/ParseWhole.h>

namespace limn
{

const char* ToString(VulkanDeviceType type)
{
    static constexpr const char* k_Names[] = {"other", "integrated GPU", "discrete GPU",
                                              "virtual GPU", "software"};
    return k_Names[static_cast<std::size_t>(type)];
}

std::vector<VulkanDeviceInfo> EnumerateVulkanDevices()
{
    std::vector<VulkanDeviceInfo> result;
    try
    {
        const vulkan::VulkanInstance instance{false};
        for (VkPhysicalDevice device : instance.PhysicalDevices())
        {
            result.push_back(vulkan::DescribeDevice(device));
        }
    }
    catch (const vulkan::NoDriverError&)
    {
        result.clear(); // a machine without a driver has no devices: an answer, not a failure
    }
    return result;
}

namespace vulkan
{

namespace
{

using DeviceTest = std::function<bool(std::size_t, const VulkanDeviceInfo&)>;

std::string Describe(std::size_t index, const VulkanDeviceInfo& device)
{
    return std::to_string(index) + ": '" + device.name + "' (" + ToString(device.type) + ")";
}

[[noreturn]] void Refuse(const std::vector<VulkanDeviceInfo>& devices, const std::string& why)
{
    if (devices.empty())
    {
        throw NoDriverError();
    }
    std::string message = why;
    for (std::size_t i = 0; i < devices.size(); ++i)
    {
        message += "\n  " + Describe(i, devices[i]);
        message += devices[i].isUsable() ? ": usable" : "";
        for (const std::string& problem : devices[i].problems)
        {
            message += "\n    " + problem;
        }
    }
    throw VulkanError(message);
}

std::optional<std::size_t> First(const std::vector<VulkanDeviceInfo>& devices,
                                 const DeviceTest& test)
{
    for (std::size_t i = 0; i < devices.size(); ++i)
    {
        if (devices[i].isUsable() && test(i, devices[i]))
        {
            return i;
        }
    }
    return std::nullopt;
}

DeviceChoice Chosen(const std::vector<VulkanDeviceInfo>& devices, std::size_t index,
                    const std::string& why)
{
    const VulkanDeviceInfo& device = devices[index];
    return {index, "drawing on " + Describe(index, device) + ", Vulkan " + device.apiVersion +
                       ", " + device.driverName + " " + device.driverInfo + ": " + why};
}

bool IsSoftware(std::size_t, const VulkanDeviceInfo& device)
{
    return device.type == VulkanDeviceType::Software;
}

DeviceChoice ChooseByDefault(const std::vector<VulkanDeviceInfo>& devices)
{
    const auto gpu = First(devices, [](std::size_t i, const VulkanDeviceInfo& device)
                           { return !IsSoftware(i, device); });
    if (gpu)
    {
        return Chosen(devices, *gpu, "the first usable GPU");
    }
    if (const auto software = First(devices, IsSoftware))
    {
        return Chosen(devices, *software, "no usable GPU, so the software device");
    }
    Refuse(devices, "no usable Vulkan device:");
}

VulkanDeviceType ToDeviceType(VkPhysicalDeviceType type)
{
    static_assert(VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU ==
                      static_cast<int>(VulkanDeviceType::IntegratedGpu) &&
                  VK_PHYSICAL_DEVICE_TYPE_CPU == static_cast<int>(VulkanDeviceType::Software));
    return type <= VK_PHYSICAL_DEVICE_TYPE_CPU ? static_cast<VulkanDeviceType>(type)
                                               : VulkanDeviceType::Other;
}

std::string VersionText(std::uint32_t version)
{
    return std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
           std::to_string(VK_API_VERSION_MINOR(version)) + "." +
           std::to_string(VK_API_VERSION_PATCH(version));
}

} // namespace

DeviceChoice ChooseDevice(const std::vector<VulkanDeviceInfo>& devices, std::string_view request)
{
    if (request.empty())
    {
        return ChooseByDefault(devices);
    }
    const std::string asked = "'" + std::string(request) + "' was asked for";
    DeviceTest test = [wanted = ToLower(request)](std::size_t, const VulkanDeviceInfo& device)
    {
        return ToLower(device.name).find(wanted) != std::string::npos;
    };
    if (request == "software")
    {
        test = IsSoftware;
    }
    else if (const std::optional<std::size_t> index = ParseWhole<std::size_t>(request))
    {
        test = [index](std::size_t i, const VulkanDeviceInfo&)
        {
            return i == *index;
        };
    }
    if (const auto found = First(devices, test))
    {
        return Chosen(devices, *found, asked);
    }
    Refuse(devices, "no usable Vulkan device is '" + std::string(request) + "'; there are:");
}

std::vector<VkQueueFamilyProperties> QueueFamilies(VkPhysicalDevice device)
{
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    return families;
}

std::optional<std::uint32_t> GraphicsQueueFamily(VkPhysicalDevice device)
{
    const std::vector<VkQueueFamilyProperties> families = QueueFamilies(device);
    // Vulkan promises one that does both where one draws.
    for (const VkQueueFlags wanted : {VkQueueFlags{VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT},
                                      VkQueueFlags{VK_QUEUE_GRAPHICS_BIT}})
    {
        for (std::uint32_t i = 0; i < families.size(); ++i)
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
    const auto driver = ReadProperties<VkPhysicalDeviceDriverProperties>(
        device, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES);
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(device, &properties);
    VulkanDeviceInfo info;
    info.name = properties.deviceName;
    info.type = ToDeviceType(properties.deviceType);
    info.apiVersion = VersionText(properties.apiVersion);
    info.driverName = driver.driverName;
    info.driverInfo = driver.driverInfo;
    const VkPhysicalDeviceLimits& limits = properties.limits;
    info.subPixelPrecisionBits = static_cast<int>(limits.subPixelPrecisionBits);
    if (properties.apiVersion < VK_API_VERSION_1_3)
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

} // namespace vulkan

} // namespace limn
