#pragma once

#include <algorithm>
#include <string>
#include <vector>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

/// Returns "VK_ERROR_DEVICE_LOST" and the like, or the number if this table does not know the
/// result.
std::string ResultName(VkResult result);

/// @throws VulkanError if `result` is an error; VK_INCOMPLETE and the like are none
void Check(VkResult result, const char* call, const std::string& object = {});

/// Returns a structure of Vulkan with zeros behind its type.
template <typename Structure>
Structure Make(VkStructureType type)
{
    Structure structure{};
    structure.sType = type;
    return structure;
}

/// Fills a list with two calls, the first for the number of elements, the second for the elements;
/// repeats them if the number grew in between.
/// @param call  takes the count and the elements; the elements are null the first time
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

/// Returns whether one of the listed structures has this name.
template <typename Element, std::size_t Size>
bool Contains(const std::vector<Element>& list, char (Element::*member)[Size],
              std::string_view name)
{
    return std::ranges::any_of(list,
                               [&](const Element& element) { return element.*member == name; });
}

} // namespace limn::vulkan
