#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

/// The optional device extensions of limn that a device has.
struct OptionalExtensions
{
    bool extendedState = false; ///< VK_EXT_extended_dynamic_state3
    bool advancedBlend = false; ///< VK_EXT_blend_operation_advanced
    bool conservative = false;  ///< VK_EXT_conservative_rasterization
    /// VK_KHR_portability_subset: the device is a layer over another API, as on macOS, and lacks
    /// some of what Vulkan promises. If a device has this extension, it must be enabled.
    bool portability = false;

    std::vector<const char*> Names() const;
};

OptionalExtensions FindExtensions(VkPhysicalDevice device);

/// The chained feature structures of Vulkan 1.3 and of extensions.
struct FeatureChain
{
    /// @param extensions  the device must have these
    explicit FeatureChain(const OptionalExtensions& extensions);
    FeatureChain(const FeatureChain&) = delete;
    FeatureChain& operator=(const FeatureChain&) = delete;

    VkPhysicalDeviceFeatures2 core{};
    VkPhysicalDeviceVulkan11Features v11{};
    VkPhysicalDeviceVulkan12Features v12{};
    VkPhysicalDeviceVulkan13Features v13{};
    VkPhysicalDeviceExtendedDynamicState3FeaturesEXT extendedState{};
    VkPhysicalDeviceBlendOperationAdvancedFeaturesEXT advancedBlend{};
    /// All true if the extension is absent.
    VkPhysicalDevicePortabilitySubsetFeaturesKHR portability{};
};

/// Returns one sentence for each feature that limn requires and that `offered` lacks.
std::vector<std::string> MissingFeatures(FeatureChain& offered);

/// Returns the sorted Unity names of features that a shader can require (`#pragma require`) and
/// that a device with these enabled features lacks. They exclude what every device of Vulkan 1.3
/// has. A name such as "compute wavebasic" is missing in kernels.
/// @param fragments, kernels  the subgroup operations that fragment functions and kernels support,
///     0 if none
std::vector<std::string> MissingShaderFeatures(const FeatureChain& enabled,
                                               const VkPhysicalDeviceLimits& limits,
                                               VkSubgroupFeatureFlags fragments,
                                               VkSubgroupFeatureFlags kernels);

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
std::vector<MissingCapability> MissingCapabilities(FeatureChain& enabled,
                                                   VkSubgroupFeatureFlags subgroup);

/// @throws DrawError with the name of the feature, if the module declares one of the capabilities
void RequireCapabilities(const std::vector<std::uint32_t>& spirv,
                         std::span<const MissingCapability> missing);

/// Returns one sentence for each feature, extension and limit of which the device has less than
/// limn can use. It says what the device lacks and what that costs.
std::vector<std::string> Lacks(FeatureChain& offered, const OptionalExtensions& extensions,
                               const VkPhysicalDeviceLimits& limits);

/// Sets in `wanted` the features that limn uses: all that it requires, and those of the others that
/// are offered.
void ChooseFeatures(FeatureChain& offered, FeatureChain& wanted);

} // namespace limn::vulkan
