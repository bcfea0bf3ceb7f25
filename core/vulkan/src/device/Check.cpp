#include "device/Check.h"

#include <limn/vulkan/VulkanError.h>

namespace limn
{

VulkanError::VulkanError(const std::string& sentence) : std::runtime_error(sentence) {}

namespace
{

/// Returns what a result means and what helps, ", ..." behind its name; "" where that says it.
std::string MeaningOf(const std::string& result)
{
    return result == "VK_ERROR_OUT_OF_DEVICE_MEMORY"
               ? ", the device has no memory left; a smaller picture needs less"
           : result == "VK_ERROR_OUT_OF_HOST_MEMORY" ? ", the machine has no memory left"
           : result == "VK_ERROR_DEVICE_LOST"        ? ", the device has stopped"
                                                     : "";
}

} // namespace

VulkanError::VulkanError(std::string call, std::string result, std::string object)
    : std::runtime_error(call + " failed" + (object.empty() ? "" : " for '" + object + "'") + ": " +
                         result + MeaningOf(result)),
      m_Call(std::move(call)),
      m_Result(std::move(result)),
      m_Object(std::move(object))
{
}

namespace vulkan
{

std::string ResultName(VkResult result)
{
    static constexpr std::pair<VkResult, const char*> k_Names[] = {
        {VK_SUCCESS, "VK_SUCCESS"},
        {VK_NOT_READY, "VK_NOT_READY"},
        {VK_TIMEOUT, "VK_TIMEOUT"},
        {VK_INCOMPLETE, "VK_INCOMPLETE"},
        {VK_ERROR_OUT_OF_HOST_MEMORY, "VK_ERROR_OUT_OF_HOST_MEMORY"},
        {VK_ERROR_OUT_OF_DEVICE_MEMORY, "VK_ERROR_OUT_OF_DEVICE_MEMORY"},
        {VK_ERROR_INITIALIZATION_FAILED, "VK_ERROR_INITIALIZATION_FAILED"},
        {VK_ERROR_DEVICE_LOST, "VK_ERROR_DEVICE_LOST"},
        {VK_ERROR_MEMORY_MAP_FAILED, "VK_ERROR_MEMORY_MAP_FAILED"},
        {VK_ERROR_LAYER_NOT_PRESENT, "VK_ERROR_LAYER_NOT_PRESENT"},
        {VK_ERROR_EXTENSION_NOT_PRESENT, "VK_ERROR_EXTENSION_NOT_PRESENT"},
        {VK_ERROR_FEATURE_NOT_PRESENT, "VK_ERROR_FEATURE_NOT_PRESENT"},
        {VK_ERROR_INCOMPATIBLE_DRIVER, "VK_ERROR_INCOMPATIBLE_DRIVER"},
        {VK_ERROR_TOO_MANY_OBJECTS, "VK_ERROR_TOO_MANY_OBJECTS"},
        {VK_ERROR_FORMAT_NOT_SUPPORTED, "VK_ERROR_FORMAT_NOT_SUPPORTED"},
        {VK_ERROR_FRAGMENTED_POOL, "VK_ERROR_FRAGMENTED_POOL"},
        {VK_ERROR_OUT_OF_POOL_MEMORY, "VK_ERROR_OUT_OF_POOL_MEMORY"},
        {VK_ERROR_UNKNOWN, "VK_ERROR_UNKNOWN"},
    };
    const auto known = std::ranges::find(k_Names, result, &std::pair<VkResult, const char*>::first);
    return known != std::end(k_Names) ? known->second
                                      : "VkResult " + std::to_string(static_cast<int>(result));
}

void Check(VkResult result, const char* call, const std::string& object)
{
    if (result < VK_SUCCESS)
    {
        throw VulkanError(call, ResultName(result), object);
    }
}

} // namespace vulkan

} // namespace limn
