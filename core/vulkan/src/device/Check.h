#pragma once

#include <string>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

/// "VK_ERROR_DEVICE_LOST"; the number for a result unknown to this table.
std::string ResultName(VkResult result);

/// @throws VulkanError if `result` is an error; VK_INCOMPLETE and the like pass
void Check(VkResult result, const char* call, const std::string& object = {});

} // namespace limn::vulkan
