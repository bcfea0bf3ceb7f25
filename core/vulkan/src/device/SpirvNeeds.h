#pragma once

#include "device/DeviceFeatures.h"

#include <cstdint>
#include <span>
#include <vector>

namespace limn::vulkan
{

/// A capability of SPIR-V that a device does not take, and the feature that would let it.
struct MissingCapability
{
    std::uint32_t capability = 0; ///< of OpCapability
    const char* feature = "";     ///< Vulkan's name
};

/// The operations of subgroups that programs of a stage may do, 0 if none.
VkSubgroupFeatureFlags SubgroupOperations(const VkPhysicalDeviceSubgroupProperties& device,
                                          VkShaderStageFlagBits stage);

/// Lists the capabilities that a device made with these features does not take, of those that HLSL
/// can lead to. Source: the SPIR-V environment of Vulkan 1.3's specification.
/// @param subgroup  see SubgroupOperations
std::vector<MissingCapability> MissingCapabilities(const FeatureChain& enabled,
                                                   VkSubgroupFeatureFlags subgroup);

/// @throws DrawError that names the feature, if the module declares one of the capabilities
void RequireCapabilities(const std::vector<std::uint32_t>& spirv,
                         std::span<const MissingCapability> missing);

} // namespace limn::vulkan
