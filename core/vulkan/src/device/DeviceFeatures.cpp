#include "device/DeviceFeatures.h"

#include "device/Check.h"
#include "device/Spirv.h"
#include <limn/core/DrawError.h>

namespace limn::vulkan
{

namespace
{

/// A feature that limn uses.
struct Feature
{
    const char* name; ///< Vulkan's
    VkBool32& (*in)(FeatureChain& chain);
    const char* meaning;
    std::uint32_t capability = 0;      ///< SPIR-V's that needs it; 0 = none
    std::uint32_t otherCapability = 0; ///< likewise
};

#define LIMN_FEATURE(structure, feature)                                                           \
#feature, [](FeatureChain & chain) -> VkBool32& {                                              \
        return chain.structure.feature;                                                            \
    }

/// Every feature without which limn does not draw, and what it is needed for.
constexpr Feature k_NeededFeatures[] = {
    {LIMN_FEATURE(core.features, independentBlend), "a blend state per target"},
    {LIMN_FEATURE(core.features, fullDrawIndexUint32), "32-bit mesh indices"},
    {LIMN_FEATURE(v12, timelineSemaphore), "to follow frames in flight"},
    {LIMN_FEATURE(v13, dynamicRendering), "passes"},
    {LIMN_FEATURE(v13, synchronization2), "barriers"},
    {LIMN_FEATURE(v13, shaderDemoteToHelperInvocation), "clip() in shaders"},
};

/// Every feature that limn uses where it is offered, and what a device without it costs.
constexpr Feature k_OptionalFeatures[] = {
    {LIMN_FEATURE(core.features, depthClamp), "ZClip False is refused"},
    {LIMN_FEATURE(core.features, logicOp), "logical BlendOps are refused"},
    {LIMN_FEATURE(core.features, geometryShader),
     "geometry functions and SV_PrimitiveID in fragment functions are refused",
     spv::CapabilityGeometry},
    {LIMN_FEATURE(core.features, tessellationShader),
     "shaders that ask for tessellation (#pragma target 4.6 and 5.0) use their next SubShader",
     spv::CapabilityTessellation},
    {LIMN_FEATURE(core.features, imageCubeArray), "arrays of cubemaps are refused",
     spv::CapabilityImageCubeArray, spv::CapabilitySampledCubeArray},
    {LIMN_FEATURE(core.features, samplerAnisotropy), "anisoLevel has no effect"},
    {LIMN_FEATURE(core.features, sampleRateShading),
     "fragment functions that run once a sample are refused", spv::CapabilitySampleRateShading},
    {LIMN_FEATURE(core.features, shaderClipDistance), "SV_ClipDistance is refused",
     spv::CapabilityClipDistance},
    {LIMN_FEATURE(core.features, shaderCullDistance), "SV_CullDistance is refused",
     spv::CapabilityCullDistance},
    {LIMN_FEATURE(core.features, shaderImageGatherExtended),
     "Gather with an offset that is not constant is refused", spv::CapabilityImageGatherExtended},
    {LIMN_FEATURE(core.features, vertexPipelineStoresAndAtomics),
     "vertex and geometry functions that write to buffers or textures are refused"},
    {LIMN_FEATURE(core.features, fragmentStoresAndAtomics),
     "fragment functions that write to buffers or textures are refused"},
    {LIMN_FEATURE(core.features, shaderUniformBufferArrayDynamicIndexing),
     "arrays of constant buffers are refused where the index is not constant",
     spv::CapabilityUniformBufferArrayDynamicIndexing},
    {LIMN_FEATURE(core.features, shaderSampledImageArrayDynamicIndexing),
     "arrays of textures are refused where the index is not constant",
     spv::CapabilitySampledImageArrayDynamicIndexing},
    {LIMN_FEATURE(core.features, shaderStorageBufferArrayDynamicIndexing),
     "arrays of structured buffers are refused where the index is not constant",
     spv::CapabilityStorageBufferArrayDynamicIndexing},
    {LIMN_FEATURE(core.features, shaderStorageImageReadWithoutFormat),
     "kernels that read a writable texture cost a pipeline for each format",
     spv::CapabilityStorageImageReadWithoutFormat},
    {LIMN_FEATURE(core.features, shaderStorageImageWriteWithoutFormat), "kernels are refused",
     spv::CapabilityStorageImageWriteWithoutFormat},
    {LIMN_FEATURE(core.features, shaderStorageImageExtendedFormats),
     "writable textures of rarer formats are refused", spv::CapabilityStorageImageExtendedFormats},
    {LIMN_FEATURE(core.features, shaderInt16), "integers of 16 bits are refused",
     spv::CapabilityInt16},
    {LIMN_FEATURE(core.features, shaderInt64), "integers of 64 bits are refused",
     spv::CapabilityInt64},
    {LIMN_FEATURE(v11, shaderDrawParameters), "SV_StartInstanceLocation is refused",
     spv::CapabilityDrawParameters},
    {LIMN_FEATURE(v12, samplerMirrorClampToEdge), "TextureWrapMode.MirrorOnce is drawn as Clamp"},
    {LIMN_FEATURE(v12, scalarBlockLayout),
     "kernels and structured buffers whose elements Direct3D packs more tightly are refused"},
    {LIMN_FEATURE(v12, shaderFloat16), "half is of 32 bits always", spv::CapabilityFloat16},
    {LIMN_FEATURE(v12, shaderOutputLayer),
     "SV_RenderTargetArrayIndex is refused but in geometry functions", spv::CapabilityShaderLayer},
    {LIMN_FEATURE(v12, shaderBufferInt64Atomics), "atomics of 64 bits on buffers are refused"},
    {LIMN_FEATURE(v12, shaderSharedInt64Atomics),
     "atomics of 64 bits on groupshared variables are refused"},
    {LIMN_FEATURE(portability, samplerMipLodBias), "a mipMapBias other than 0 is refused"},
    {LIMN_FEATURE(portability, mutableComparisonSamplers),
     "SamplerComparisonState and with it the shadows of lights are refused"},
};

#undef LIMN_FEATURE

/// A limit of which Direct3D 11 lets a shader count on so much.
struct UsefulLimit
{
    const char* name; ///< Vulkan's
    std::uint32_t VkPhysicalDeviceLimits::*limit;
    std::uint32_t useful;
    const char* cost; ///< behind the number that the device has
};

constexpr UsefulLimit k_UsefulLimits[] = {
    {"maxColorAttachments", &VkPhysicalDeviceLimits::maxColorAttachments, 8,
     "targets are the most that a pass can draw into at once"},
    {"maxFragmentCombinedOutputResources",
     &VkPhysicalDeviceLimits::maxFragmentCombinedOutputResources, 16,
     "targets, writable buffers and textures are the most that a fragment function can write to"},
    {"maxImageDimension2D", &VkPhysicalDeviceLimits::maxImageDimension2D, 16384,
     "texels are the greatest width and height of a texture"},
    {"maxPerStageDescriptorSampledImages",
     &VkPhysicalDeviceLimits::maxPerStageDescriptorSampledImages, 128,
     "textures are the most that a function of a shader can read"},
    {"maxPerStageDescriptorSamplers", &VkPhysicalDeviceLimits::maxPerStageDescriptorSamplers, 16,
     "samplers are the most that a function of a shader can use"},
    {"maxPerStageDescriptorStorageBuffers",
     &VkPhysicalDeviceLimits::maxPerStageDescriptorStorageBuffers, 16,
     "structured buffers are the most that a function of a shader can use"},
    {"maxPerStageDescriptorStorageImages",
     &VkPhysicalDeviceLimits::maxPerStageDescriptorStorageImages, 8,
     "writable textures are the most that a function of a shader can use"},
    {"maxPerStageDescriptorUniformBuffers",
     &VkPhysicalDeviceLimits::maxPerStageDescriptorUniformBuffers, 14,
     "constant buffers are the most that a function of a shader can read"},
    {"maxPerStageResources", &VkPhysicalDeviceLimits::maxPerStageResources, 150,
     "textures, buffers and targets are the most that a function of a shader can use"},
    {"maxUniformBufferRange", &VkPhysicalDeviceLimits::maxUniformBufferRange, 65536,
     "bytes are the greatest size of a constant buffer"},
    {"maxVertexOutputComponents", &VkPhysicalDeviceLimits::maxVertexOutputComponents, 128,
     "numbers are the most that a vertex function can pass on"},
};

constexpr std::pair<bool OptionalExtensions::*, const char*> k_Extensions[] = {
    {&OptionalExtensions::extendedState, VK_EXT_EXTENDED_DYNAMIC_STATE_3_EXTENSION_NAME},
    {&OptionalExtensions::advancedBlend, VK_EXT_BLEND_OPERATION_ADVANCED_EXTENSION_NAME},
    {&OptionalExtensions::conservative, VK_EXT_CONSERVATIVE_RASTERIZATION_EXTENSION_NAME},
    {&OptionalExtensions::portability, VK_KHR_PORTABILITY_SUBSET_EXTENSION_NAME},
};

} // namespace

std::vector<const char*> OptionalExtensions::Names() const
{
    std::vector<const char*> names;
    for (const auto& [has, name] : k_Extensions)
    {
        names.insert(names.end(), this->*has ? 1 : 0, name);
    }
    return names;
}

OptionalExtensions FindExtensions(VkPhysicalDevice device)
{
    std::vector<VkExtensionProperties> extensions;
    const auto fill = [&](std::uint32_t* count, VkExtensionProperties* list)
    {
        return vkEnumerateDeviceExtensionProperties(device, nullptr, count, list);
    };
    Check(FillList(extensions, fill), "vkEnumerateDeviceExtensionProperties");
    OptionalExtensions found;
    for (const auto& [has, name] : k_Extensions)
    {
        found.*has = Contains(extensions, &VkExtensionProperties::extensionName, name);
    }
    return found;
}

FeatureChain::FeatureChain(const OptionalExtensions& extensions)
{
    core.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    v11.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES;
    v12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    v13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    extendedState.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTENDED_DYNAMIC_STATE_3_FEATURES_EXT;
    advancedBlend.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BLEND_OPERATION_ADVANCED_FEATURES_EXT;
    portability.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PORTABILITY_SUBSET_FEATURES_KHR;
    portability.samplerMipLodBias = VK_TRUE;
    portability.mutableComparisonSamplers = VK_TRUE;
    core.pNext = &v11;
    v11.pNext = &v12;
    v12.pNext = &v13;
    void** next = &v13.pNext;
    const auto chain = [&next](bool has, auto& structure)
    {
        *next = has ? &structure : nullptr;
        next = has ? &structure.pNext : next;
    };
    chain(extensions.extendedState, extendedState);
    chain(extensions.advancedBlend, advancedBlend);
    chain(extensions.portability, portability);
}

std::vector<std::string> MissingFeatures(FeatureChain& offered)
{
    std::vector<std::string> missing;
    for (const Feature& feature : k_NeededFeatures)
    {
        missing.insert(missing.end(), feature.in(offered) == VK_TRUE ? 0 : 1,
                       std::string("it lacks the feature ") + feature.name + ", needed for " +
                           feature.meaning);
    }
    return missing;
}

std::vector<std::string> MissingShaderFeatures(const FeatureChain& enabled,
                                               const VkPhysicalDeviceLimits& limits,
                                               VkSubgroupFeatureFlags fragments,
                                               VkSubgroupFeatureFlags kernels)
{
    const VkPhysicalDeviceFeatures& core = enabled.core.features;
    const VkPhysicalDeviceVulkan12Features& v12 = enabled.v12;
    const auto has = [](VkBool32 feature)
    {
        return feature == VK_TRUE;
    };
    constexpr std::uint32_t k_Interpolators = 32 * 4; // of four components each
    const std::pair<const char*, bool> features[] = {
        {"barycentrics", false}, // an extension that limn does not ask for
        {"compute", has(core.shaderStorageImageWriteWithoutFormat) && has(v12.scalarBlockLayout)},
        {"cubearray", has(core.imageCubeArray)},
        {"geometry", has(core.geometryShader)},
        {"int64bufferatomics", has(core.shaderInt64) && has(v12.shaderBufferInt64Atomics)},
        {"int64groupsharedatomics", has(core.shaderInt64) && has(v12.shaderSharedInt64Atomics)},
        {"interpolators32", limits.maxVertexOutputComponents >= k_Interpolators &&
                                limits.maxFragmentInputComponents >= k_Interpolators},
        {"mrt8", limits.maxColorAttachments >= 8},
        {"native16bit", has(core.shaderInt16) && has(v12.shaderFloat16)},
        {"randomwrite", has(core.fragmentStoresAndAtomics)},
        // No pragma names this one: structured buffers ask for it by their elements.
        {"scalarblocklayout", has(v12.scalarBlockLayout)},
        {"setrtarrayindexfromanyshader", has(v12.shaderOutputLayer)},
        {"tesshw", has(core.tessellationShader)},
        {"tessellation", has(core.tessellationShader)},
        {"uav", has(core.fragmentStoresAndAtomics)},
    };
    std::vector<std::string> missing;
    for (const auto& [name, isThere] : features)
    {
        missing.insert(missing.end(), isThere ? 0 : 1, name);
    }
    constexpr std::pair<const char*, VkSubgroupFeatureFlagBits> k_Operations[] = {
        {"quadshuffle", VK_SUBGROUP_FEATURE_QUAD_BIT},
        {"waveballot", VK_SUBGROUP_FEATURE_BALLOT_BIT},
        {"wavebasic", VK_SUBGROUP_FEATURE_BASIC_BIT},
        {"wavemath", VK_SUBGROUP_FEATURE_ARITHMETIC_BIT},
        {"wavemultiprefix", VK_SUBGROUP_FEATURE_PARTITIONED_BIT_NV},
        {"wavevote", VK_SUBGROUP_FEATURE_VOTE_BIT},
    };
    for (const auto& [name, operation] : k_Operations)
    {
        missing.insert(missing.end(), (fragments & operation) == 0 ? 1 : 0, name);
        missing.insert(missing.end(), (kernels & operation) == 0 ? 1 : 0,
                       std::string("compute ") + name);
    }
    std::ranges::sort(missing);
    return missing;
}

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

std::vector<MissingCapability> MissingCapabilities(FeatureChain& enabled,
                                                   VkSubgroupFeatureFlags subgroup)
{
    // limn asks no device for these two.
    std::vector<MissingCapability> missing = {{spv::CapabilityFloat64, "shaderFloat64"},
                                              {spv::CapabilityStorageImageArrayDynamicIndexing,
                                               "shaderStorageImageArrayDynamicIndexing"}};
    for (const Feature& feature : k_OptionalFeatures)
    {
        for (const std::uint32_t capability : {feature.capability, feature.otherCapability})
        {
            const bool isMissing = capability != 0 && feature.in(enabled) == VK_FALSE;
            missing.insert(missing.end(), isMissing ? 1 : 0, {capability, feature.name});
        }
    }
    constexpr std::pair<MissingCapability, VkSubgroupFeatureFlagBits> k_Operations[] = {
        {{spv::CapabilityGroupNonUniform, "wave operations"}, VK_SUBGROUP_FEATURE_BASIC_BIT},
        {{spv::CapabilityGroupNonUniformVote, "wave votes"}, VK_SUBGROUP_FEATURE_VOTE_BIT},
        {{spv::CapabilityGroupNonUniformArithmetic, "wave arithmetic"},
         VK_SUBGROUP_FEATURE_ARITHMETIC_BIT},
        {{spv::CapabilityGroupNonUniformBallot, "wave ballots"}, VK_SUBGROUP_FEATURE_BALLOT_BIT},
        {{spv::CapabilityGroupNonUniformShuffle, "wave shuffles"}, VK_SUBGROUP_FEATURE_SHUFFLE_BIT},
        {{spv::CapabilityGroupNonUniformQuad, "quad operations"}, VK_SUBGROUP_FEATURE_QUAD_BIT},
    };
    for (const auto& [need, operation] : k_Operations)
    {
        missing.insert(missing.end(), (subgroup & operation) == 0 ? 1 : 0, need);
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
                        const auto known = op == spv::OpCapability
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

std::vector<std::string> Lacks(FeatureChain& offered, const OptionalExtensions& extensions,
                               const VkPhysicalDeviceLimits& limits)
{
    std::vector<std::string> lacks;
    const auto add = [&](bool has, const std::string& what, const char* cost)
    {
        lacks.insert(lacks.end(), has ? 0 : 1, "it has no " + what + ": " + cost);
    };
    for (const Feature& feature : k_OptionalFeatures)
    {
        add(feature.in(offered) == VK_TRUE, feature.name, feature.meaning);
    }
    add(extensions.extendedState, VK_EXT_EXTENDED_DYNAMIC_STATE_3_EXTENSION_NAME,
        "each state of blending costs a pipeline");
    add(extensions.advancedBlend, VK_EXT_BLEND_OPERATION_ADVANCED_EXTENSION_NAME,
        "BlendOp Multiply, Screen, Overlay and their like are refused");
    add(extensions.conservative, VK_EXT_CONSERVATIVE_RASTERIZATION_EXTENSION_NAME,
        "Conservative True is refused");
    for (const UsefulLimit& limit : k_UsefulLimits)
    {
        if (const std::uint32_t has = limits.*limit.limit; has < limit.useful)
        {
            lacks.push_back(std::string(limit.name) + " is " + std::to_string(has) + ": " +
                            std::to_string(has) + " " + limit.cost);
        }
    }
    return lacks;
}

void ChooseFeatures(FeatureChain& offered, FeatureChain& wanted)
{
    for (const Feature& feature : k_NeededFeatures)
    {
        feature.in(wanted) = VK_TRUE;
    }
    for (const Feature& feature : k_OptionalFeatures)
    {
        feature.in(wanted) = feature.in(offered);
    }
    // Vulkan 1.3 has these always. Programs for Direct3D count on zeros from beyond the end.
    wanted.core.features.robustBufferAccess = offered.core.features.robustBufferAccess;
    wanted.v13.robustImageAccess = offered.v13.robustImageAccess;
    wanted.v13.maintenance4 = offered.v13.maintenance4;
    wanted.v13.shaderTerminateInvocation = offered.v13.shaderTerminateInvocation;
    wanted.portability = offered.portability;
    wanted.portability.pNext = nullptr; // it is the chain's last
    const bool blend = offered.extendedState.extendedDynamicState3ColorBlendEnable == VK_TRUE &&
                       offered.extendedState.extendedDynamicState3ColorBlendEquation == VK_TRUE &&
                       offered.extendedState.extendedDynamicState3ColorWriteMask == VK_TRUE;
    wanted.extendedState.extendedDynamicState3ColorBlendEnable = blend ? VK_TRUE : VK_FALSE;
    wanted.extendedState.extendedDynamicState3ColorBlendEquation = blend ? VK_TRUE : VK_FALSE;
    wanted.extendedState.extendedDynamicState3ColorWriteMask = blend ? VK_TRUE : VK_FALSE;
    wanted.advancedBlend.advancedBlendCoherentOperations =
        offered.advancedBlend.advancedBlendCoherentOperations;
}

} // namespace limn::vulkan
