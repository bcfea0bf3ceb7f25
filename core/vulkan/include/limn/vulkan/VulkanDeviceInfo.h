#pragma once

#include <string>
#include <vector>

namespace limn
{

enum class VulkanDeviceType
{
    Other,
    IntegratedGpu,
    DiscreteGpu,
    VirtualGpu,
    Software ///< runs on the CPU, e.g. Mesa's llvmpipe
};

/// "discrete GPU", "software", ...
const char* ToString(VulkanDeviceType type);

/// What a device says of itself, and whether limn can draw with it.
struct VulkanDeviceInfo
{
    std::string name;
    VulkanDeviceType type = VulkanDeviceType::Other;
    std::string apiVersion; ///< "1.3.230"
    std::string driverName;
    std::string driverInfo;
    /// The bits behind the point of a vertex's place in the picture, in pixels; at least 4.
    int subPixelPrecisionBits = 0;
    std::vector<std::string> problems; ///< one sentence for each thing that limn needs and misses
    /// One for each thing that limn can use and that is not there, or less of it: "no
    /// geometryShader: geometry functions are refused …".
    std::vector<std::string> lacks = {};

    bool isUsable() const { return problems.empty(); }
    bool operator==(const VulkanDeviceInfo&) const = default;
};

/// Every device the loader offers, in its order: VulkanDeviceOptions::device counts in this list.
/// Empty where there is no driver.
/// @throws VulkanError if the loader fails for another reason
std::vector<VulkanDeviceInfo> EnumerateVulkanDevices();

} // namespace limn
