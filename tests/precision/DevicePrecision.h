#pragma once

#include "vulkan/GpuTestDevice.h"

#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <limn/vulkan/VulkanDevice.h>
#include <stdexcept>

namespace limn::test
{

/// Returns what the device that tests share says of itself.
inline const VulkanDeviceInfo& SharedDeviceInfo()
{
    static const VulkanDeviceInfo info = []
    {
        for (const VulkanDeviceInfo& device : EnumerateVulkanDevices())
        {
            if (device.name == SharedDevice().deviceName())
            {
                return device;
            }
        }
        throw std::runtime_error("no Vulkan device is called " + SharedDevice().deviceName());
    }();
    return info;
}

/// How far a vertex may be drawn from its place, along each axis, in pixels. Vulkan keeps so many
/// bits of a place in the picture (VkPhysicalDeviceLimits::subPixelPrecisionBits) and does not say
/// which way the others are rounded. A triangle whose corners are moved so far shows at each place
/// what the exact one shows at a place that is no farther away: places in it are weighted means of
/// its corners, and means of moved corners are moved no farther than these.
inline double SubPixel()
{
    return std::exp2(-SharedDeviceInfo().subPixelPrecisionBits);
}

/// Whether the device places corners less finely than lavapipe, which drew the goldens.
inline bool HasCoarseCorners()
{
    return SubPixel() > 0x1p-8;
}

/// A place, and the eight around it that the device may take for it where it draws a triangle.
inline std::array<glm::dvec2, 9> MovedPlaces(const glm::dvec2& place = glm::dvec2(0.0))
{
    std::array<glm::dvec2, 9> places;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        const glm::dvec2 step(static_cast<double>((i + 1) % 3) - 1.0,
                              static_cast<double>((i + 4) / 3 % 3) - 1.0);
        places[i] = place + step * SubPixel();
    }
    return places;
}

} // namespace limn::test
