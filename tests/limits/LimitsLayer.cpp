/// A Vulkan layer that lets a driver have less than it has, so that validation and limn believe it:
/// it stands between the validation layer and the driver. LIMN_LOWER says what, when an instance is
/// made: "geometryShader=0,maxPerStageDescriptorSamplers=16". Each is the name of a feature or of a
/// limit, but for "portability" (the device is a layer over another API and lacks what that may
/// lack) and "fullHeap" (the device's own memory is full, the host's is not).

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <vector>
#define VK_ENABLE_BETA_EXTENSIONS
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

namespace
{

constexpr const char* k_Portability = VK_KHR_PORTABILITY_SUBSET_EXTENSION_NAME;
constexpr VkDeviceSize k_FullHeapBytes = VkDeviceSize{256} << 20;

/// What the entry points share. One thread at a time makes instances and devices.
struct State
{
    std::map<std::string, std::uint32_t> lowered;
    std::map<void*, PFN_vkGetInstanceProcAddr> instances; ///< by the loader's key
    std::map<void*, PFN_vkGetDeviceProcAddr> devices;
    std::map<void*, VkInstance> handles;
};
State s_State;

bool isLowered(const char* name)
{
    return s_State.lowered.contains(name);
}

/// The first word of what the loader dispatches on; an instance's devices share its.
template <typename Handle>
void* KeyOf(Handle handle)
{
    return *reinterpret_cast<void**>(handle);
}

template <typename Function>
Function* Next(VkPhysicalDevice device, const char* name)
{
    void* key = KeyOf(device);
    return reinterpret_cast<Function*>(s_State.instances.at(key)(s_State.handles.at(key), name));
}

template <typename Function>
Function* Next(VkDevice device, const char* name)
{
    return reinterpret_cast<Function*>(s_State.devices.at(KeyOf(device))(device, name));
}

#define LIMN_NEXT(owner, function) Next<decltype(function)>(owner, #function)

void ReadLowered()
{
    s_State.lowered.clear();
    const char* text = std::getenv("LIMN_LOWER");
    for (std::string rest = text == nullptr ? "" : text; !rest.empty();)
    {
        const std::string entry = rest.substr(0, rest.find(','));
        rest.erase(0, entry.size() + 1);
        const std::size_t equals = entry.find('=');
        s_State.lowered[entry.substr(0, equals)] =
            static_cast<std::uint32_t>(std::stoul(entry.substr(equals + 1)));
    }
}

/// The loader's link to the next layer, which is handed on from one to the next.
template <typename LayerInfo, VkStructureType Type, typename Info>
LayerInfo* LinkOf(const Info* info)
{
    auto* link = static_cast<LayerInfo*>(const_cast<void*>(info->pNext));
    while (link->sType != Type || link->function != VK_LAYER_LINK_INFO)
    {
        link = static_cast<LayerInfo*>(const_cast<void*>(link->pNext));
    }
    return link;
}

void Lower(VkPhysicalDeviceLimits& limits)
{
#define LIMN_LIMIT(name)                                                                           \
    if (isLowered(#name))                                                                          \
    {                                                                                              \
        limits.name = s_State.lowered.at(#name);                                                   \
    }
    LIMN_LIMIT(maxBoundDescriptorSets)
    LIMN_LIMIT(maxComputeWorkGroupInvocations)
    LIMN_LIMIT(maxDescriptorSetSampledImages)
    LIMN_LIMIT(maxDescriptorSetSamplers)
    LIMN_LIMIT(maxDescriptorSetStorageBuffers)
    LIMN_LIMIT(maxDescriptorSetStorageImages)
    LIMN_LIMIT(maxDescriptorSetUniformBuffers)
    LIMN_LIMIT(maxFragmentCombinedOutputResources)
    LIMN_LIMIT(maxPerStageDescriptorSampledImages)
    LIMN_LIMIT(maxPerStageDescriptorSamplers)
    LIMN_LIMIT(maxPerStageDescriptorStorageBuffers)
    LIMN_LIMIT(maxPerStageDescriptorStorageImages)
    LIMN_LIMIT(maxPerStageDescriptorUniformBuffers)
    LIMN_LIMIT(maxPerStageResources)
    LIMN_LIMIT(maxPushConstantsSize)
    LIMN_LIMIT(maxSamplerAllocationCount)
    LIMN_LIMIT(maxVertexInputAttributes)
    LIMN_LIMIT(maxVertexInputBindings)
#undef LIMN_LIMIT
}

void Lower(VkPhysicalDeviceFeatures& features)
{
#define LIMN_FEATURE(name) features.name = isLowered(#name) ? VK_FALSE : features.name;
    LIMN_FEATURE(fillModeNonSolid)
    LIMN_FEATURE(fragmentStoresAndAtomics)
    LIMN_FEATURE(geometryShader)
    LIMN_FEATURE(samplerAnisotropy)
    LIMN_FEATURE(vertexPipelineStoresAndAtomics)
    LIMN_FEATURE(wideLines)
#undef LIMN_FEATURE
}

void Lower(VkPhysicalDeviceMemoryProperties& memory)
{
    if (isLowered("fullHeap"))
    {
        // In front of the driver's own heaps and kinds, which are the host's then.
        std::copy_backward(memory.memoryHeaps, memory.memoryHeaps + memory.memoryHeapCount,
                           memory.memoryHeaps + memory.memoryHeapCount + 1);
        std::copy_backward(memory.memoryTypes, memory.memoryTypes + memory.memoryTypeCount,
                           memory.memoryTypes + memory.memoryTypeCount + 1);
        memory.memoryHeaps[0] = {k_FullHeapBytes, VK_MEMORY_HEAP_DEVICE_LOCAL_BIT};
        memory.memoryTypes[0] = {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0};
        for (std::uint32_t i = 1; i <= memory.memoryHeapCount; ++i)
        {
            memory.memoryHeaps[i].flags &= ~VkFlags{VK_MEMORY_HEAP_DEVICE_LOCAL_BIT};
        }
        for (std::uint32_t i = 1; i <= memory.memoryTypeCount; ++i)
        {
            memory.memoryTypes[i].propertyFlags &= ~VkFlags{VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT};
            ++memory.memoryTypes[i].heapIndex;
        }
        ++memory.memoryHeapCount;
        ++memory.memoryTypeCount;
    }
}

void Lower(VkMemoryRequirements& needs)
{
    needs.memoryTypeBits =
        isLowered("fullHeap") ? needs.memoryTypeBits << 1 | 1 : needs.memoryTypeBits;
}

VKAPI_ATTR VkResult VKAPI_CALL CreateInstance(const VkInstanceCreateInfo* info,
                                              const VkAllocationCallbacks* callbacks,
                                              VkInstance* instance)
{
    ReadLowered();
    auto* link =
        LinkOf<VkLayerInstanceCreateInfo, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO>(info);
    const PFN_vkGetInstanceProcAddr next = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const VkResult result = reinterpret_cast<PFN_vkCreateInstance>(
        next(nullptr, "vkCreateInstance"))(info, callbacks, instance);
    if (result == VK_SUCCESS)
    {
        s_State.instances[KeyOf(*instance)] = next;
        s_State.handles[KeyOf(*instance)] = *instance;
    }
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL CreateDevice(VkPhysicalDevice physicalDevice,
                                            const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* callbacks,
                                            VkDevice* device)
{
    auto* link = LinkOf<VkLayerDeviceCreateInfo, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO>(info);
    const PFN_vkGetDeviceProcAddr next = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    std::vector<const char*> names; // without the one that is not the driver's
    for (std::uint32_t i = 0; i < info->enabledExtensionCount; ++i)
    {
        if (std::strcmp(info->ppEnabledExtensionNames[i], k_Portability) != 0)
        {
            names.push_back(info->ppEnabledExtensionNames[i]);
        }
    }
    VkDeviceCreateInfo handedOn = *info;
    handedOn.enabledExtensionCount = static_cast<std::uint32_t>(names.size());
    handedOn.ppEnabledExtensionNames = names.data();
    const VkResult result =
        LIMN_NEXT(physicalDevice, vkCreateDevice)(physicalDevice, &handedOn, callbacks, device);
    if (result == VK_SUCCESS)
    {
        s_State.devices[KeyOf(*device)] = next;
    }
    return result;
}

VKAPI_ATTR void VKAPI_CALL GetProperties(VkPhysicalDevice device,
                                         VkPhysicalDeviceProperties* properties)
{
    LIMN_NEXT(device, vkGetPhysicalDeviceProperties)(device, properties);
    Lower(properties->limits);
}

VKAPI_ATTR void VKAPI_CALL GetProperties2(VkPhysicalDevice device,
                                          VkPhysicalDeviceProperties2* properties)
{
    LIMN_NEXT(device, vkGetPhysicalDeviceProperties2)(device, properties);
    Lower(properties->properties.limits);
}

VKAPI_ATTR void VKAPI_CALL GetFeatures(VkPhysicalDevice device, VkPhysicalDeviceFeatures* features)
{
    LIMN_NEXT(device, vkGetPhysicalDeviceFeatures)(device, features);
    Lower(*features);
}

VKAPI_ATTR void VKAPI_CALL GetFeatures2(VkPhysicalDevice device,
                                        VkPhysicalDeviceFeatures2* features)
{
    LIMN_NEXT(device, vkGetPhysicalDeviceFeatures2)(device, features);
    Lower(features->features);
    for (auto* next = static_cast<VkBaseOutStructure*>(features->pNext); next != nullptr;
         next = next->pNext)
    {
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PORTABILITY_SUBSET_FEATURES_KHR)
        {
            auto* portability =
                reinterpret_cast<VkPhysicalDevicePortabilitySubsetFeaturesKHR*>(next);
            const auto type = portability->sType;
            void* const following = portability->pNext;
            *portability = {}; // as bare as may be
            portability->sType = type;
            portability->pNext = following;
            portability->mutableComparisonSamplers =
                s_State.lowered.at("portability") == 2 ? VK_TRUE : VK_FALSE; // as on macOS
        }
    }
}

VKAPI_ATTR void VKAPI_CALL GetMemory(VkPhysicalDevice device,
                                     VkPhysicalDeviceMemoryProperties* memory)
{
    LIMN_NEXT(device, vkGetPhysicalDeviceMemoryProperties)(device, memory);
    Lower(*memory);
}

VKAPI_ATTR void VKAPI_CALL GetMemory2(VkPhysicalDevice device,
                                      VkPhysicalDeviceMemoryProperties2* memory)
{
    LIMN_NEXT(device, vkGetPhysicalDeviceMemoryProperties2)(device, memory);
    Lower(memory->memoryProperties);
}

VKAPI_ATTR VkResult VKAPI_CALL EnumerateExtensions(VkPhysicalDevice device, const char* layer,
                                                   std::uint32_t* count,
                                                   VkExtensionProperties* extensions)
{
    const auto next = LIMN_NEXT(device, vkEnumerateDeviceExtensionProperties);
    std::uint32_t all = 0;
    next(device, layer, &all, nullptr);
    std::vector<VkExtensionProperties> list(all);
    next(device, layer, &all, list.data());
    std::erase_if(list, [](const VkExtensionProperties& extension)
                  { return std::strcmp(extension.extensionName, k_Portability) == 0; });
    if (isLowered("portability"))
    {
        std::strcpy(list.emplace_back().extensionName, k_Portability);
    }
    const auto size = static_cast<std::uint32_t>(list.size());
    const std::uint32_t copied = extensions == nullptr ? size : std::min(*count, size);
    if (extensions != nullptr)
    {
        std::copy_n(list.begin(), copied, extensions);
    }
    *count = copied;
    return copied < size ? VK_INCOMPLETE : VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL AllocateMemory(VkDevice device, const VkMemoryAllocateInfo* info,
                                              const VkAllocationCallbacks* callbacks,
                                              VkDeviceMemory* memory)
{
    VkMemoryAllocateInfo handedOn = *info;
    if (isLowered("fullHeap") && handedOn.memoryTypeIndex-- == 0)
    {
        return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    }
    return LIMN_NEXT(device, vkAllocateMemory)(device, &handedOn, callbacks, memory);
}

VKAPI_ATTR void VKAPI_CALL GetBufferNeeds(VkDevice device, VkBuffer buffer,
                                          VkMemoryRequirements* needs)
{
    LIMN_NEXT(device, vkGetBufferMemoryRequirements)(device, buffer, needs);
    Lower(*needs);
}

VKAPI_ATTR void VKAPI_CALL GetImageNeeds(VkDevice device, VkImage image,
                                         VkMemoryRequirements* needs)
{
    LIMN_NEXT(device, vkGetImageMemoryRequirements)(device, image, needs);
    Lower(*needs);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL GetDeviceProcAddr(VkDevice device, const char* name);
VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL GetInstanceProcAddr(VkInstance instance, const char* name);

/// The layer's own entry point, or null.
PFN_vkVoidFunction Own(const char* name)
{
#define LIMN_OWN(function, own)                                                                    \
    {                                                                                              \
#function, reinterpret_cast < PFN_vkVoidFunction>(own)                                     \
    }
    static const std::map<std::string, PFN_vkVoidFunction> s_Own = {
        LIMN_OWN(vkAllocateMemory, AllocateMemory),
        LIMN_OWN(vkCreateDevice, CreateDevice),
        LIMN_OWN(vkCreateInstance, CreateInstance),
        LIMN_OWN(vkEnumerateDeviceExtensionProperties, EnumerateExtensions),
        LIMN_OWN(vkGetBufferMemoryRequirements, GetBufferNeeds),
        LIMN_OWN(vkGetDeviceProcAddr, GetDeviceProcAddr),
        LIMN_OWN(vkGetImageMemoryRequirements, GetImageNeeds),
        LIMN_OWN(vkGetInstanceProcAddr, GetInstanceProcAddr),
        LIMN_OWN(vkGetPhysicalDeviceFeatures, GetFeatures),
        LIMN_OWN(vkGetPhysicalDeviceFeatures2, GetFeatures2),
        LIMN_OWN(vkGetPhysicalDeviceMemoryProperties, GetMemory),
        LIMN_OWN(vkGetPhysicalDeviceMemoryProperties2, GetMemory2),
        LIMN_OWN(vkGetPhysicalDeviceProperties, GetProperties),
        LIMN_OWN(vkGetPhysicalDeviceProperties2, GetProperties2),
    };
#undef LIMN_OWN
    const auto found = s_Own.find(name);
    return found == s_Own.end() ? nullptr : found->second;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL GetDeviceProcAddr(VkDevice device, const char* name)
{
    const PFN_vkVoidFunction next = s_State.devices.at(KeyOf(device))(device, name);
    const PFN_vkVoidFunction own = Own(name);
    return next != nullptr && own != nullptr ? own : next;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL GetInstanceProcAddr(VkInstance instance, const char* name)
{
    if (const PFN_vkVoidFunction own = Own(name))
    {
        return own;
    }
    return instance == nullptr ? nullptr : s_State.instances.at(KeyOf(instance))(instance, name);
}

} // namespace

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version)
{
    version->loaderLayerInterfaceVersion = 2;
    version->pfnGetInstanceProcAddr = GetInstanceProcAddr;
    version->pfnGetDeviceProcAddr = GetDeviceProcAddr;
    version->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
