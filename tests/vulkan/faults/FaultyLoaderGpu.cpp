#include "faults/FaultyCalls.h"

#include <algorithm>

namespace limn::test::faulty_loader
{

State s_State;

VkResult FailureOf(const std::string& name, Errors errors)
{
    const auto may = [&](VkResult result)
    {
        return result == VK_ERROR_OUT_OF_HOST_MEMORY || result == VK_ERROR_OUT_OF_DEVICE_MEMORY ||
               std::find(errors.begin(), errors.end(), result) != errors.end();
    };
    if (s_State.lost && may(VK_ERROR_DEVICE_LOST) && name != "vkCreateDevice")
    {
        return VK_ERROR_DEVICE_LOST;
    }
    const bool counts = s_State.function.empty() ? may(s_State.result) : name == s_State.function;
    if (s_State.result == VK_SUCCESS || !counts)
    {
        return VK_SUCCESS;
    }
    ++s_State.calls;
    const bool fails =
        s_State.function.empty() ? s_State.calls == s_State.number : s_State.calls > s_State.spared;
    if (!fails)
    {
        return VK_SUCCESS;
    }
    if (s_State.failed.empty())
    {
        s_State.failed = name;
    }
    s_State.lost = s_State.result == VK_ERROR_DEVICE_LOST && name != "vkCreateDevice";
    return s_State.result;
}

void FailCall(int number, VkResult result)
{
    FailNothing();
    s_State.number = number;
    s_State.result = result;
}

void FailFunction(const std::string& name, VkResult result, int spared)
{
    FailNothing();
    s_State.function = name;
    s_State.result = result;
    s_State.spared = spared;
}

void FailNothing()
{
    s_State.result = VK_SUCCESS;
    s_State.function.clear();
    s_State.failed.clear();
    s_State.calls = 0;
}

const std::string& FailedFunction()
{
    return s_State.failed;
}

std::map<std::string, int> LiveObjects()
{
    std::map<std::string, int> live = s_State.objects;
    std::erase_if(live, [](const auto& entry) { return entry.second == 0; });
    return live;
}

void LimitStorageBuffers(std::uint32_t bytes)
{
    s_State.storageLimit = bytes;
    s_State.largestStorage = 0;
}

void LimitUniformBuffers(std::uint32_t bytes)
{
    s_State.uniformLimit = bytes;
}

VkDeviceSize LargestStorageBuffer()
{
    return s_State.largestStorage;
}

bool Covers(const std::string& function)
{
    const std::initializer_list<std::string> askedFor = {"vkSetDebugUtilsObjectNameEXT",
                                                         "vkCreateDebugUtilsMessengerEXT"};
    return std::find(askedFor.begin(), askedFor.end(), function) != askedFor.end() ||
           dlsym(RTLD_DEFAULT, function.c_str()) != dlsym(RTLD_NEXT, function.c_str());
}

} // namespace limn::test::faulty_loader
