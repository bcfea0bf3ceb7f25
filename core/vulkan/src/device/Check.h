#pragma once

#include <string>
#include <vector>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

/// "VK_ERROR_DEVICE_LOST"; the number for a result unknown to this table.
std::string ResultName(VkResult result);

/// @throws VulkanError if `result` is an error; VK_INCOMPLETE and the like pass
void Check(VkResult result, const char* call, const std::string& object = {});

/// Fills a list as Vulkan gives lists out: how many there are, then so many; again where they have
/// become more in between.
/// @param call  takes the count and the elements, which are null the first time
template <typename Element, typename Call>
VkResult FillList(std::vector<Element>& list, Call&& call)
{
    VkResult result = VK_INCOMPLETE;
    while (result == VK_INCOMPLETE)
    {
        std::uint32_t count = 0;
        result = call(&count, static_cast<Element*>(nullptr));
        list.resize(result == VK_SUCCESS ? count : 0);
        result = list.empty() ? result : call(&count, list.data());
        list.resize(result == VK_SUCCESS ? count : 0);
    }
    return result;
}

} // namespace limn::vulkan
