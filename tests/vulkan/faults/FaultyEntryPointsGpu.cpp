#include "faults/FaultyCalls.h"

#include <cstring>

namespace limn::test::faulty_loader
{

namespace
{

VKAPI_ATTR VkResult VKAPI_CALL SetObjectName(VkDevice device,
                                             const VkDebugUtilsObjectNameInfoEXT* info)
{
    return Call(s_State.setObjectName.at(device), "vkSetDebugUtilsObjectNameEXT", {}, device, info);
}

VKAPI_ATTR VkResult VKAPI_CALL CreateMessenger(VkInstance instance,
                                               const VkDebugUtilsMessengerCreateInfoEXT* info,
                                               const VkAllocationCallbacks* callbacks,
                                               VkDebugUtilsMessengerEXT* messenger)
{
    const VkResult result =
        Call(s_State.createMessenger.at(instance), "vkCreateDebugUtilsMessengerEXT", {}, instance,
             info, callbacks, messenger);
    Made("DebugUtilsMessenger", result);
    return result;
}

VKAPI_ATTR void VKAPI_CALL DestroyMessenger(VkInstance instance, VkDebugUtilsMessengerEXT messenger,
                                            const VkAllocationCallbacks* callbacks)
{
    Destroyed("DebugUtilsMessenger", messenger);
    s_State.destroyMessenger.at(instance)(instance, messenger, callbacks);
}

/// Keeps the loader's entry point if it is the one of this name, and gives out the other.
template <typename Owner, typename Function>
void Replace(const char* asked, const char* name, PFN_vkVoidFunction& entry, Owner owner,
             std::map<Owner, Function*>& kept, Function* own)
{
    if (entry != nullptr && std::strcmp(asked, name) == 0)
    {
        kept[owner] = reinterpret_cast<Function*>(entry);
        entry = reinterpret_cast<PFN_vkVoidFunction>(own);
    }
}

} // namespace

// clang-format off

#define LIMN_OBJECT(Kind)                                                                          \
    VKAPI_ATTR VkResult VKAPI_CALL vkCreate##Kind(                                                 \
        VkDevice device, const Vk##Kind##CreateInfo* info, const VkAllocationCallbacks* callbacks, \
        Vk##Kind* object)                                                                          \
    {                                                                                              \
        const VkResult result =                                                                    \
            Call(LIMN_NEXT(vkCreate##Kind), {}, device, info, callbacks, object);                  \
        Made(#Kind, result);                                                                       \
        return result;                                                                             \
    }                                                                                              \
    VKAPI_ATTR void VKAPI_CALL vkDestroy##Kind(VkDevice device, Vk##Kind object,                   \
                                               const VkAllocationCallbacks* callbacks)             \
    {                                                                                              \
        Destroyed(#Kind, object);                                                                  \
        Next<decltype(vkDestroy##Kind)>("vkDestroy" #Kind)(device, object, callbacks);             \
    }

/// A call that may fail for want of memory only.
#define LIMN_CALL(function, parameters, ...)                                                       \
    VKAPI_ATTR VkResult VKAPI_CALL function parameters                                             \
    {                                                                                              \
        return Call(LIMN_NEXT(function), {}, __VA_ARGS__);                                         \
    }

/// A call that fills a list of `count` elements.
#define LIMN_LIST(function, errors, list, parameters, ...)                                         \
    VKAPI_ATTR VkResult VKAPI_CALL function parameters                                             \
    {                                                                                              \
        return CallList(#function, errors, count, list,                                            \
                        [&] { return Next<decltype(function)>(#function)(__VA_ARGS__); });         \
    }

extern "C"
{

LIMN_OBJECT(Buffer)
LIMN_OBJECT(CommandPool)
LIMN_OBJECT(DescriptorPool)
LIMN_OBJECT(DescriptorSetLayout)
LIMN_OBJECT(Image)
LIMN_OBJECT(ImageView)
LIMN_OBJECT(PipelineCache)
LIMN_OBJECT(PipelineLayout)
LIMN_OBJECT(QueryPool)
LIMN_OBJECT(Sampler)
LIMN_OBJECT(Semaphore)
LIMN_OBJECT(ShaderModule)

LIMN_CALL(vkEnumerateInstanceVersion, (std::uint32_t* version), version)
LIMN_LIST(vkEnumerateInstanceLayerProperties, Errors{}, layers,
          (std::uint32_t* count, VkLayerProperties* layers),
          count, layers)
LIMN_LIST(vkEnumerateInstanceExtensionProperties, Errors{VK_ERROR_LAYER_NOT_PRESENT}, extensions,
          (const char* layer, std::uint32_t* count, VkExtensionProperties* extensions),
          layer, count, extensions)
LIMN_LIST(vkEnumeratePhysicalDevices, Errors{VK_ERROR_INITIALIZATION_FAILED}, devices,
          (VkInstance instance, std::uint32_t* count, VkPhysicalDevice* devices),
          instance, count, devices)
LIMN_LIST(vkEnumerateDeviceExtensionProperties, Errors{VK_ERROR_LAYER_NOT_PRESENT}, extensions,
          (VkPhysicalDevice device, const char* layer, std::uint32_t* count,
           VkExtensionProperties* extensions),
          device, layer, count, extensions)
LIMN_LIST(vkGetPipelineCacheData, Errors{}, data,
          (VkDevice device, VkPipelineCache cache, std::size_t* count, void* data),
          device, cache, count, data)
LIMN_CALL(vkBindBufferMemory,
          (VkDevice device, VkBuffer buffer, VkDeviceMemory memory, VkDeviceSize offset),
          device, buffer, memory, offset)
LIMN_CALL(vkBindImageMemory,
          (VkDevice device, VkImage image, VkDeviceMemory memory, VkDeviceSize offset),
          device, image, memory, offset)
LIMN_CALL(vkResetDescriptorPool,
          (VkDevice device, VkDescriptorPool pool, VkDescriptorPoolResetFlags flags),
          device, pool, flags)
LIMN_CALL(vkAllocateCommandBuffers,
          (VkDevice device, const VkCommandBufferAllocateInfo* info, VkCommandBuffer* buffers),
          device, info, buffers)
LIMN_CALL(vkResetCommandPool,
          (VkDevice device, VkCommandPool pool, VkCommandPoolResetFlags flags),
          device, pool, flags)
LIMN_CALL(vkBeginCommandBuffer, (VkCommandBuffer buffer, const VkCommandBufferBeginInfo* info), buffer, info)
LIMN_CALL(vkEndCommandBuffer, (VkCommandBuffer buffer), buffer)

} // extern "C"

// clang-format on

extern "C"
{
    // Instances and devices

    VKAPI_ATTR VkResult VKAPI_CALL vkCreateInstance(const VkInstanceCreateInfo* info,
                                                    const VkAllocationCallbacks* callbacks,
                                                    VkInstance* instance)
    {
        const VkResult result = Call(LIMN_NEXT(vkCreateInstance),
                                     {VK_ERROR_INITIALIZATION_FAILED, VK_ERROR_LAYER_NOT_PRESENT,
                                      VK_ERROR_EXTENSION_NOT_PRESENT, VK_ERROR_INCOMPATIBLE_DRIVER},
                                     info, callbacks, instance);
        Made("Instance", result);
        return result;
    }

    VKAPI_ATTR void VKAPI_CALL vkDestroyInstance(VkInstance instance,
                                                 const VkAllocationCallbacks* callbacks)
    {
        Destroyed("Instance", instance);
        Next<decltype(vkDestroyInstance)>("vkDestroyInstance")(instance, callbacks);
    }

    VKAPI_ATTR VkResult VKAPI_CALL vkGetPhysicalDeviceToolProperties(
        VkPhysicalDevice device, std::uint32_t* count, VkPhysicalDeviceToolProperties* tools)
    {
        const VkResult result =
            Call(LIMN_NEXT(vkGetPhysicalDeviceToolProperties), {}, device, count, tools);
        *count += result == VK_SUCCESS && tools == nullptr && s_State.hasTool ? 1 : 0;
        return result;
    }

    VKAPI_ATTR void VKAPI_CALL vkGetPhysicalDeviceProperties(VkPhysicalDevice device,
                                                             VkPhysicalDeviceProperties* properties)
    {
        Next<decltype(vkGetPhysicalDeviceProperties)>("vkGetPhysicalDeviceProperties")(device,
                                                                                       properties);
        if (s_State.storageLimit != 0)
        {
            properties->limits.maxStorageBufferRange = s_State.storageLimit;
        }
        if (s_State.uniformLimit != 0)
        {
            properties->limits.maxUniformBufferRange = s_State.uniformLimit;
        }
    }

    VKAPI_ATTR void VKAPI_CALL vkGetPhysicalDeviceMemoryProperties(
        VkPhysicalDevice device, VkPhysicalDeviceMemoryProperties* properties)
    {
        Next<decltype(vkGetPhysicalDeviceMemoryProperties)>("vkGetPhysicalDeviceMemoryProperties")(
            device, properties);
        s_State.memoryTypes = properties->memoryTypeCount;
    }

    VKAPI_ATTR VkResult VKAPI_CALL vkGetPhysicalDeviceImageFormatProperties(
        VkPhysicalDevice device, VkFormat format, VkImageType type, VkImageTiling tiling,
        VkImageUsageFlags usage, VkImageCreateFlags flags, VkImageFormatProperties* properties)
    {
        return Call(LIMN_NEXT(vkGetPhysicalDeviceImageFormatProperties),
                    {VK_ERROR_FORMAT_NOT_SUPPORTED}, device, format, type, tiling, usage, flags,
                    properties);
    }

    VKAPI_ATTR VkResult VKAPI_CALL vkCreateDevice(VkPhysicalDevice physicalDevice,
                                                  const VkDeviceCreateInfo* info,
                                                  const VkAllocationCallbacks* callbacks,
                                                  VkDevice* device)
    {
        const VkResult result =
            Call(LIMN_NEXT(vkCreateDevice),
                 {VK_ERROR_INITIALIZATION_FAILED, VK_ERROR_EXTENSION_NOT_PRESENT,
                  VK_ERROR_FEATURE_NOT_PRESENT, VK_ERROR_TOO_MANY_OBJECTS, VK_ERROR_DEVICE_LOST},
                 physicalDevice, info, callbacks, device);
        Made("Device", result);
        return result;
    }

    VKAPI_ATTR void VKAPI_CALL vkDestroyDevice(VkDevice device,
                                               const VkAllocationCallbacks* callbacks)
    {
        Destroyed("Device", device);
        s_State.lost = false;
        Next<decltype(vkDestroyDevice)>("vkDestroyDevice")(device, callbacks);
    }

    VKAPI_ATTR VkResult VKAPI_CALL vkDeviceWaitIdle(VkDevice device)
    {
        if (s_State.lost)
        {
            // What was lost for limn runs on in the driver: it must be done before anything is
            // freed.
            Next<decltype(vkDeviceWaitIdle)>("vkDeviceWaitIdle")(device);
        }
        return Call(LIMN_NEXT(vkDeviceWaitIdle), {VK_ERROR_DEVICE_LOST}, device);
    }

    VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL vkGetInstanceProcAddr(VkInstance instance,
                                                                   const char* name)
    {
        PFN_vkVoidFunction entry =
            Next<decltype(vkGetInstanceProcAddr)>("vkGetInstanceProcAddr")(instance, name);
        Replace(name, "vkCreateDebugUtilsMessengerEXT", entry, instance, s_State.createMessenger,
                CreateMessenger);
        Replace(name, "vkDestroyDebugUtilsMessengerEXT", entry, instance, s_State.destroyMessenger,
                DestroyMessenger);
        return entry;
    }

    VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL vkGetDeviceProcAddr(VkDevice device, const char* name)
    {
        PFN_vkVoidFunction entry =
            Next<decltype(vkGetDeviceProcAddr)>("vkGetDeviceProcAddr")(device, name);
        Replace(name, "vkSetDebugUtilsObjectNameEXT", entry, device, s_State.setObjectName,
                SetObjectName);
        return entry;
    }

    // Memory

    VKAPI_ATTR VkResult VKAPI_CALL vkAllocateMemory(VkDevice device,
                                                    const VkMemoryAllocateInfo* info,
                                                    const VkAllocationCallbacks* callbacks,
                                                    VkDeviceMemory* memory)
    {
        const VkResult result = Call(LIMN_NEXT(vkAllocateMemory), {VK_ERROR_TOO_MANY_OBJECTS},
                                     device, info, callbacks, memory);
        Made("DeviceMemory", result);
        return result;
    }

    VKAPI_ATTR void VKAPI_CALL vkFreeMemory(VkDevice device, VkDeviceMemory memory,
                                            const VkAllocationCallbacks* callbacks)
    {
        Destroyed("DeviceMemory", memory);
        Next<decltype(vkFreeMemory)>("vkFreeMemory")(device, memory, callbacks);
    }

    VKAPI_ATTR VkResult VKAPI_CALL vkMapMemory(VkDevice device, VkDeviceMemory memory,
                                               VkDeviceSize offset, VkDeviceSize size,
                                               VkMemoryMapFlags flags, void** data)
    {
        return Call(LIMN_NEXT(vkMapMemory), {VK_ERROR_MEMORY_MAP_FAILED}, device, memory, offset,
                    size, flags, data);
    }

    // Pipelines and descriptors

    VKAPI_ATTR VkResult VKAPI_CALL
    vkCreateGraphicsPipelines(VkDevice device, VkPipelineCache cache, std::uint32_t count,
                              const VkGraphicsPipelineCreateInfo* infos,
                              const VkAllocationCallbacks* callbacks, VkPipeline* pipelines)
    {
        const VkResult result = Call(LIMN_NEXT(vkCreateGraphicsPipelines), {}, device, cache, count,
                                     infos, callbacks, pipelines);
        Made("Pipeline", result);
        return result;
    }

    VKAPI_ATTR VkResult VKAPI_CALL
    vkCreateComputePipelines(VkDevice device, VkPipelineCache cache, std::uint32_t count,
                             const VkComputePipelineCreateInfo* infos,
                             const VkAllocationCallbacks* callbacks, VkPipeline* pipelines)
    {
        const VkResult result = Call(LIMN_NEXT(vkCreateComputePipelines), {}, device, cache, count,
                                     infos, callbacks, pipelines);
        Made("Pipeline", result);
        return result;
    }

    VKAPI_ATTR void VKAPI_CALL vkDestroyPipeline(VkDevice device, VkPipeline pipeline,
                                                 const VkAllocationCallbacks* callbacks)
    {
        Destroyed("Pipeline", pipeline);
        Next<decltype(vkDestroyPipeline)>("vkDestroyPipeline")(device, pipeline, callbacks);
    }

    VKAPI_ATTR VkResult VKAPI_CALL vkAllocateDescriptorSets(VkDevice device,
                                                            const VkDescriptorSetAllocateInfo* info,
                                                            VkDescriptorSet* sets)
    {
        return Call(LIMN_NEXT(vkAllocateDescriptorSets),
                    {VK_ERROR_FRAGMENTED_POOL, VK_ERROR_OUT_OF_POOL_MEMORY}, device, info, sets);
    }

    VKAPI_ATTR void VKAPI_CALL vkUpdateDescriptorSets(VkDevice device, std::uint32_t writeCount,
                                                      const VkWriteDescriptorSet* writes,
                                                      std::uint32_t copyCount,
                                                      const VkCopyDescriptorSet* copies)
    {
        for (std::uint32_t i = 0; i < writeCount; ++i)
        {
            if (writes[i].descriptorType == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER)
            {
                s_State.largestStorage =
                    std::max(s_State.largestStorage, writes[i].pBufferInfo->range);
            }
        }
        Next<decltype(vkUpdateDescriptorSets)>("vkUpdateDescriptorSets")(device, writeCount, writes,
                                                                         copyCount, copies);
    }

    // Commands and the queue

    VKAPI_ATTR VkResult VKAPI_CALL vkQueueSubmit2(VkQueue queue, std::uint32_t count,
                                                  const VkSubmitInfo2* submits, VkFence fence)
    {
        return Call(LIMN_NEXT(vkQueueSubmit2), {VK_ERROR_DEVICE_LOST}, queue, count, submits,
                    fence);
    }

    VKAPI_ATTR VkResult VKAPI_CALL vkGetSemaphoreCounterValue(VkDevice device,
                                                              VkSemaphore semaphore,
                                                              std::uint64_t* value)
    {
        return Call(LIMN_NEXT(vkGetSemaphoreCounterValue), {VK_ERROR_DEVICE_LOST}, device,
                    semaphore, value);
    }

    VKAPI_ATTR VkResult VKAPI_CALL vkWaitSemaphores(VkDevice device,
                                                    const VkSemaphoreWaitInfo* info,
                                                    std::uint64_t timeout)
    {
        return Call(LIMN_NEXT(vkWaitSemaphores), {VK_ERROR_DEVICE_LOST, VK_TIMEOUT}, device, info,
                    timeout);
    }

    VKAPI_ATTR VkResult VKAPI_CALL vkGetQueryPoolResults(VkDevice device, VkQueryPool pool,
                                                         std::uint32_t first, std::uint32_t count,
                                                         std::size_t size, void* data,
                                                         VkDeviceSize stride,
                                                         VkQueryResultFlags flags)
    {
        Errors errors{VK_ERROR_DEVICE_LOST};
        if ((flags & VK_QUERY_RESULT_WAIT_BIT) == 0)
        {
            errors.push_back(VK_NOT_READY);
        }
        return Call(LIMN_NEXT(vkGetQueryPoolResults), errors, device, pool, first, count, size,
                    data, stride, flags);
    }

} // extern "C"

} // namespace limn::test::faulty_loader
