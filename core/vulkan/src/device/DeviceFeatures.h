#pragma once

#include <string>
#include <vector>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

/// Which of the device extensions that limn uses where they are there.
struct OptionalExtensions
{
    bool extendedState = false; ///< VK_EXT_extended_dynamic_state3
    bool advancedBlend = false; ///< VK_EXT_blend_operation_advanced
    bool conservative = false;  ///< VK_EXT_conservative_rasterization
    /// VK_KHR_portability_subset: the device is a layer over another API, as on macOS, and lacks
    /// some of what Vulkan promises. Where it is there it must be asked for.
    bool portability = false;

    std::vector<const char*> Names() const;
};

OptionalExtensions FindExtensions(VkPhysicalDevice device);

/// The feature structures of Vulkan 1.3 and of extensions, chained.
struct FeatureChain
{
    /// @param extensions  that the device must have
    explicit FeatureChain(const OptionalExtensions& extensions);
    FeatureChain(const FeatureChain&) = delete;
    FeatureChain& operator=(const FeatureChain&) = delete;

    VkPhysicalDeviceFeatures2 core{};
    VkPhysicalDeviceVulkan11Features v11{};
    VkPhysicalDeviceVulkan12Features v12{};
    VkPhysicalDeviceVulkan13Features v13{};
    VkPhysicalDeviceExtendedDynamicState3FeaturesEXT extendedState{};
    VkPhysicalDeviceBlendOperationAdvancedFeaturesEXT advancedBlend{};
    VkPhysicalDevicePortabilitySubsetFeaturesKHR portability{}; ///< all true where it is absent
};

/// One sentence for each feature that limn cannot do without and that `offered` lacks.
std::vector<std::string> MissingFeatures(const FeatureChain& offered);

/// Unity's names of what a shader may require (`#pragma require`) and a device made with these
/// features lacks; sorted. What every device of Vulkan 1.3 has is not among them.
/// "compute wavebasic" and its like are missing in kernels.
/// @param fragments, kernels  the operations of subgroups that they may do, 0 if none
std::vector<std::string> MissingShaderFeatures(const FeatureChain& enabled,
                                               const VkPhysicalDeviceLimits& limits,
                                               VkSubgroupFeatureFlags fragments,
                                               VkSubgroupFeatureFlags kernels);

/// One sentence for each feature, extension and limit of which the device has less than limn can
/// use: what it lacks and what that costs.
std::vector<std::string> Lacks(FeatureChain& offered, const OptionalExtensions& extensions,
                               const VkPhysicalDeviceLimits& limits);

/// Sets in `wanted` what limn uses: all it needs, and of the rest what is offered.
void ChooseFeatures(FeatureChain& offered, FeatureChain& wanted);

} // namespace limn::vulkan
