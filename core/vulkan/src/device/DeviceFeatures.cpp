#include "device/DeviceFeatures.h"

#include "device/Check.h"
#include <algorithm>
#include <cstring>

namespace limn::vulkan
{

std::vector<const char*> OptionalExtensions::Names() const
{
    std::vector<const char*> names;
    const auto add = [&](bool has, const char* name)
    {
        names.insert(names.end(), has ? 1 : 0, name);
    };
    add(extendedState, VK_EXT_EXTENDED_DYNAMIC_STATE_3_EXTENSION_NAME);
    add(advancedBlend, VK_EXT_BLEND_OPERATION_ADVANCED_EXTENSION_NAME);
    add(conservative, VK_EXT_CONSERVATIVE_RASTERIZATION_EXTENSION_NAME);
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
    const auto has = [&](const char* name)
    {
        return std::any_of(extensions.begin(), extensions.end(),
                           [&](const VkExtensionProperties& extension)
                           { return std::strcmp(extension.extensionName, name) == 0; });
    };
    return {has(VK_EXT_EXTENDED_DYNAMIC_STATE_3_EXTENSION_NAME),
            has(VK_EXT_BLEND_OPERATION_ADVANCED_EXTENSION_NAME),
            has(VK_EXT_CONSERVATIVE_RASTERIZATION_EXTENSION_NAME)};
}

FeatureChain::FeatureChain(const OptionalExtensions& extensions)
{
    core.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    v11.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES;
    v12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    v13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    extendedState.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTENDED_DYNAMIC_STATE_3_FEATURES_EXT;
    advancedBlend.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BLEND_OPERATION_ADVANCED_FEATURES_EXT;
    core.pNext = &v11;
    v11.pNext = &v12;
    v12.pNext = &v13;
    extendedState.pNext = extensions.advancedBlend ? &advancedBlend : nullptr;
    v13.pNext = extensions.extendedState ? &extendedState : extendedState.pNext;
}

std::vector<std::string> MissingFeatures(const FeatureChain& offered)
{
    struct Need
    {
        VkBool32 has;
        const char* name;
        const char* use;
    };
    const Need needs[] = {
        {offered.core.features.independentBlend, "independentBlend", "a blend state per target"},
        {offered.core.features.fullDrawIndexUint32, "fullDrawIndexUint32", "32-bit mesh indices"},
        {offered.v12.timelineSemaphore, "timelineSemaphore", "to follow frames in flight"},
        {offered.v13.dynamicRendering, "dynamicRendering", "passes"},
        {offered.v13.synchronization2, "synchronization2", "barriers"},
        {offered.v13.shaderDemoteToHelperInvocation, "shaderDemoteToHelperInvocation",
         "clip() in shaders"},
    };
    std::vector<std::string> missing;
    for (const Need& need : needs)
    {
        if (need.has == VK_FALSE)
        {
            missing.push_back(std::string("it lacks the feature ") + need.name + ", needed for " +
                              need.use);
        }
    }
    return missing;
}

std::vector<std::string> MissingShaderFeatures(const FeatureChain& enabled,
                                               const VkPhysicalDeviceLimits& limits,
                                               VkSubgroupFeatureFlags subgroup)
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
        {"quadshuffle", (subgroup & VK_SUBGROUP_FEATURE_QUAD_BIT) != 0},
        {"randomwrite", has(core.fragmentStoresAndAtomics)},
        // No pragma names this one: structured buffers ask for it by their elements.
        {"scalarblocklayout", has(v12.scalarBlockLayout)},
        {"setrtarrayindexfromanyshader", has(v12.shaderOutputLayer)},
        {"tesshw", has(core.tessellationShader)},
        {"tessellation", has(core.tessellationShader)},
        {"uav", has(core.fragmentStoresAndAtomics)},
        {"waveballot", (subgroup & VK_SUBGROUP_FEATURE_BALLOT_BIT) != 0},
        {"wavebasic", (subgroup & VK_SUBGROUP_FEATURE_BASIC_BIT) != 0},
        {"wavemath", (subgroup & VK_SUBGROUP_FEATURE_ARITHMETIC_BIT) != 0},
        {"wavemultiprefix", (subgroup & VK_SUBGROUP_FEATURE_PARTITIONED_BIT_NV) != 0},
        {"wavevote", (subgroup & VK_SUBGROUP_FEATURE_VOTE_BIT) != 0},
    };
    std::vector<std::string> missing;
    for (const auto& [name, isThere] : features)
    {
        if (!isThere)
        {
            missing.emplace_back(name);
        }
    }
    return missing;
}

void ChooseFeatures(const FeatureChain& offered, FeatureChain& wanted)
{
    wanted.core.features.independentBlend = VK_TRUE;
    wanted.core.features.fullDrawIndexUint32 = VK_TRUE;
    wanted.v12.timelineSemaphore = VK_TRUE;
    wanted.v13.dynamicRendering = VK_TRUE;
    wanted.v13.synchronization2 = VK_TRUE;
    wanted.v13.shaderDemoteToHelperInvocation = VK_TRUE;

    constexpr VkBool32 VkPhysicalDeviceFeatures::*k_WhereOffered[] = {
        // Programs for Direct3D count on zeros from beyond the end of a buffer.
        &VkPhysicalDeviceFeatures::robustBufferAccess,
        &VkPhysicalDeviceFeatures::depthClamp,
        &VkPhysicalDeviceFeatures::logicOp,
        &VkPhysicalDeviceFeatures::geometryShader,     // SV_PrimitiveID in fragment functions
        &VkPhysicalDeviceFeatures::tessellationShader, // asked for by #pragma target 4.6 and 5.0
        &VkPhysicalDeviceFeatures::imageCubeArray,
        &VkPhysicalDeviceFeatures::samplerAnisotropy,
        &VkPhysicalDeviceFeatures::sampleRateShading,
        &VkPhysicalDeviceFeatures::shaderClipDistance,
        &VkPhysicalDeviceFeatures::shaderCullDistance,
        &VkPhysicalDeviceFeatures::shaderImageGatherExtended,
        &VkPhysicalDeviceFeatures::vertexPipelineStoresAndAtomics, // structured buffers in shaders
        &VkPhysicalDeviceFeatures::fragmentStoresAndAtomics,
        &VkPhysicalDeviceFeatures::shaderUniformBufferArrayDynamicIndexing,
        &VkPhysicalDeviceFeatures::shaderSampledImageArrayDynamicIndexing,
        &VkPhysicalDeviceFeatures::shaderStorageBufferArrayDynamicIndexing,
        &VkPhysicalDeviceFeatures::shaderStorageImageReadWithoutFormat, // writable textures
        &VkPhysicalDeviceFeatures::shaderStorageImageWriteWithoutFormat,
        &VkPhysicalDeviceFeatures::shaderStorageImageExtendedFormats,
        &VkPhysicalDeviceFeatures::shaderInt16,
        &VkPhysicalDeviceFeatures::shaderInt64,
    };
    for (const auto feature : k_WhereOffered)
    {
        wanted.core.features.*feature = offered.core.features.*feature;
    }
    wanted.v11.shaderDrawParameters = offered.v11.shaderDrawParameters;
    wanted.v12.samplerMirrorClampToEdge = offered.v12.samplerMirrorClampToEdge;
    wanted.v12.scalarBlockLayout = offered.v12.scalarBlockLayout; // structs of structured buffers
    wanted.v12.shaderFloat16 = offered.v12.shaderFloat16;
    wanted.v12.shaderOutputLayer = offered.v12.shaderOutputLayer;
    wanted.v12.shaderBufferInt64Atomics = offered.v12.shaderBufferInt64Atomics;
    wanted.v12.shaderSharedInt64Atomics = offered.v12.shaderSharedInt64Atomics;
    wanted.v13.robustImageAccess = offered.v13.robustImageAccess; // and of a texture
    wanted.v13.maintenance4 = offered.v13.maintenance4;
    wanted.v13.shaderTerminateInvocation = offered.v13.shaderTerminateInvocation;
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
