#pragma once

#include <string>
#include <vector>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

/// The feature structures of Vulkan 1.3 and of the one extension limn uses, chained.
struct FeatureChain
{
    /// @param extendedState  chains VK_EXT_extended_dynamic_state3, which the device must have
    explicit FeatureChain(bool extendedState);
    FeatureChain(const FeatureChain&) = delete;
    FeatureChain& operator=(const FeatureChain&) = delete;

    VkPhysicalDeviceFeatures2 core{};
    VkPhysicalDeviceVulkan11Features v11{};
    VkPhysicalDeviceVulkan12Features v12{};
    VkPhysicalDeviceVulkan13Features v13{};
    VkPhysicalDeviceExtendedDynamicState3FeaturesEXT extendedState{};
};

bool HasDeviceExtension(VkPhysicalDevice device, const char* name);

/// One sentence for each feature that limn cannot do without and that `offered` lacks.
std::vector<std::string> MissingFeatures(const FeatureChain& offered);

/// Unity's names of what a shader may require (`#pragma require`) and a device made with these
/// features lacks; sorted. What every device of Vulkan 1.3 has is not among them.
/// @param subgroup  the operations that fragment functions may do, 0 if none
std::vector<std::string> MissingShaderFeatures(const FeatureChain& enabled,
                                               const VkPhysicalDeviceLimits& limits,
                                               VkSubgroupFeatureFlags subgroup);

/// Sets in `wanted` what limn uses: all it needs, and of the rest what is offered.
void ChooseFeatures(const FeatureChain& offered, FeatureChain& wanted);

} // namespace limn::vulkan
