#include "device/DeviceSelection.h"

#include "device/VulkanInstance.h"
#include <algorithm>
#include <functional>
#include <limn/base/Case.h>
#include <limn/base/ParseWhole.h>

namespace limn
{

const char* ToString(VulkanDeviceType type)
{
    switch (type)
    {
    case VulkanDeviceType::IntegratedGpu:
        return "integrated GPU";
    case VulkanDeviceType::DiscreteGpu:
        return "discrete GPU";
    case VulkanDeviceType::VirtualGpu:
        return "virtual GPU";
    case VulkanDeviceType::Software:
        return "software";
    case VulkanDeviceType::Other:
        break;
    }
    return "other";
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

} // namespace vulkan

} // namespace limn
