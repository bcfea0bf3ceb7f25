#pragma once

#include "device/DeviceFeatures.h"

#include <cstdint>
#include <span>
#include <vector>

namespace limn::vulkan
{

/// A capability of SPIR-V that a device does not accept, and the feature that it would need.
struct MissingCapability
{
    std::uint32_t capability = 0; ///< the operand of OpCapability
    const char* feature = "";     ///< Vulkan's name
};

/// Returns the subgroup operations that programs of a stage can use, 0 if none.
VkSubgroupFeatureFlags SubgroupOperations(const VkPhysicalDeviceSubgroupProperties& device,
                                          VkShaderStageFlagBits stage);

/// Lists the capabilities that HLSL can lead to and that a device made with these features does not
/// accept. Source: the SPIR-V environment of Vulkan 1.3's specification.
/// @param subgroup  see SubgroupOperations
std::vector<MissingCapability> MissingCapabilities(const FeatureChain& enabled,
                                                   VkSubgroupFeatureFlags subgroup);

/// @throws DrawError with the name of the feature, if the module declares one of the capabilities
void RequireCapabilities(const std::vector<std::uint32_t>& spirv,
                         std::span<const MissingCapability> missing);

} // namespace limn::vulkan
