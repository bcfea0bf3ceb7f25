#include "device/SpirvNeeds.h"

#include "device/Spirv.h"

#include <algorithm>
#include <limn/core/DrawError.h>

namespace limn::vulkan
{

VkSubgroupFeatureFlags SubgroupOperations(const VkPhysicalDeviceSubgroupProperties& device,
                                          VkShaderStageFlagBits stage)
{
    constexpr VkShaderStageFlags k_WithQuads =
        VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT;
    if ((device.supportedStages & stage) == 0)
    {
        return 0;
    }
    return device.quadOperationsInAllStages == VK_TRUE || (stage & k_WithQuads) != 0
               ? device.supportedOperations
               : device.supportedOperations & ~VkFlags{VK_SUBGROUP_FEATURE_QUAD_BIT};
}

std::vector<MissingCapability> MissingCapabilities(const FeatureChain& enabled,
                                                   VkSubgroupFeatureFlags subgroup)
{
    const VkPhysicalDeviceFeatures& core = enabled.core.features;
    const VkPhysicalDeviceVulkan12Features& v12 = enabled.v12;
    const auto does = [subgroup](VkSubgroupFeatureFlags operations) -> VkBool32
    {
        return (subgroup & operations) == operations ? VK_TRUE : VK_FALSE;
    };
    const std::pair<MissingCapability, VkBool32> needs[] = {
        {{2, "geometryShader"}, core.geometryShader}, // SV_PrimitiveID in fragment functions, too
        {{3, "tessellationShader"}, core.tessellationShader},
        {{9, "shaderFloat16"}, v12.shaderFloat16},
        {{10, "shaderFloat64"}, core.shaderFloat64},
        {{11, "shaderInt64"}, core.shaderInt64},
        {{22, "shaderInt16"}, core.shaderInt16},
        {{25, "shaderImageGatherExtended"}, core.shaderImageGatherExtended},
        {{28, "shaderUniformBufferArrayDynamicIndexing"},
         core.shaderUniformBufferArrayDynamicIndexing},
        {{29, "shaderSampledImageArrayDynamicIndexing"},
         core.shaderSampledImageArrayDynamicIndexing},
        {{30, "shaderStorageBufferArrayDynamicIndexing"},
         core.shaderStorageBufferArrayDynamicIndexing},
        {{31, "shaderStorageImageArrayDynamicIndexing"},
         core.shaderStorageImageArrayDynamicIndexing},
        {{32, "shaderClipDistance"}, core.shaderClipDistance},
        {{33, "shaderCullDistance"}, core.shaderCullDistance},
        {{34, "imageCubeArray"}, core.imageCubeArray},
        {{35, "sampleRateShading"}, core.sampleRateShading},
        {{45, "imageCubeArray"}, core.imageCubeArray},
        {{49, "shaderStorageImageExtendedFormats"}, core.shaderStorageImageExtendedFormats},
        {{55, "shaderStorageImageReadWithoutFormat"}, core.shaderStorageImageReadWithoutFormat},
        {{56, "shaderStorageImageWriteWithoutFormat"}, core.shaderStorageImageWriteWithoutFormat},
        {{61, "wave operations"}, does(VK_SUBGROUP_FEATURE_BASIC_BIT)},
        {{62, "wave votes"}, does(VK_SUBGROUP_FEATURE_VOTE_BIT)},
        {{63, "wave arithmetic"}, does(VK_SUBGROUP_FEATURE_ARITHMETIC_BIT)},
        {{64, "wave ballots"}, does(VK_SUBGROUP_FEATURE_BALLOT_BIT)},
        {{65, "wave shuffles"}, does(VK_SUBGROUP_FEATURE_SHUFFLE_BIT)},
        {{68, "quad operations"}, does(VK_SUBGROUP_FEATURE_QUAD_BIT)},
        {{69, "shaderOutputLayer"}, v12.shaderOutputLayer},
        {{4427, "shaderDrawParameters"}, enabled.v11.shaderDrawParameters},
    };
    std::vector<MissingCapability> missing;
    for (const auto& [need, isEnabled] : needs)
    {
        missing.insert(missing.end(), isEnabled == VK_TRUE ? 0 : 1, need);
    }
    return missing;
}

void RequireCapabilities(const std::vector<std::uint32_t>& spirv,
                         std::span<const MissingCapability> missing)
{
    const MissingCapability* found = nullptr;
    EachInstruction(spirv,
                    [&](std::uint32_t op, std::span<const std::uint32_t> words)
                    {
                        const auto known = op == OpCapability
                                               ? std::ranges::find(missing, words[1],
                                                                   &MissingCapability::capability)
                                               : missing.end();
                        found = known == missing.end() ? found : &*known;
                    });
    if (found != nullptr)
    {
        throw DrawError(std::string("a program needs ") + found->feature +
                        ", which the device lacks; a compiler that is given the device's "
                        "missingShaderFeatures() takes the shader's next SubShader instead");
    }
}

} // namespace limn::vulkan
