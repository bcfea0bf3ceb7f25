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
    switch (result)
    {
    case VK_SUCCESS:
        return "VK_SUCCESS";
    case VK_NOT_READY:
        return "VK_NOT_READY";
    case VK_TIMEOUT:
        return "VK_TIMEOUT";
    case VK_INCOMPLETE:
        return "VK_INCOMPLETE";
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return "VK_ERROR_OUT_OF_HOST_MEMORY";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return "VK_ERROR_OUT_OF_DEVICE_MEMORY";
    case VK_ERROR_INITIALIZATION_FAILED:
        return "VK_ERROR_INITIALIZATION_FAILED";
    case VK_ERROR_DEVICE_LOST:
        return "VK_ERROR_DEVICE_LOST";
    case VK_ERROR_MEMORY_MAP_FAILED:
        return "VK_ERROR_MEMORY_MAP_FAILED";
    case VK_ERROR_LAYER_NOT_PRESENT:
        return "VK_ERROR_LAYER_NOT_PRESENT";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
        return "VK_ERROR_EXTENSION_NOT_PRESENT";
    case VK_ERROR_FEATURE_NOT_PRESENT:
        return "VK_ERROR_FEATURE_NOT_PRESENT";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
        return "VK_ERROR_INCOMPATIBLE_DRIVER";
    case VK_ERROR_TOO_MANY_OBJECTS:
        return "VK_ERROR_TOO_MANY_OBJECTS";
    case VK_ERROR_FORMAT_NOT_SUPPORTED:
        return "VK_ERROR_FORMAT_NOT_SUPPORTED";
    case VK_ERROR_FRAGMENTED_POOL:
        return "VK_ERROR_FRAGMENTED_POOL";
    case VK_ERROR_OUT_OF_POOL_MEMORY:
        return "VK_ERROR_OUT_OF_POOL_MEMORY";
    case VK_ERROR_UNKNOWN:
        return "VK_ERROR_UNKNOWN";
    default:
        return "VkResult " + std::to_string(static_cast<int>(result));
    }
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
