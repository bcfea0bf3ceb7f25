#include "faults/FaultyCalls.h"

#include <algorithm>

namespace limn::test::faulty_loader
{

State s_State;
std::mutex s_Mutex;

namespace
{

/// Returns what a call is to fail with where it is its turn.
VkResult NextFailure(bool mayFail)
{
    if (!mayFail)
    {
        return VK_SUCCESS;
    }
    ++s_State.calls;
    if (!s_State.function.empty())
    {
        return s_State.calls > s_State.spared ? s_State.result : VK_SUCCESS;
    }
    const Fault fault = s_State.faults.front();
    if (s_State.calls != fault.number)
    {
        return VK_SUCCESS;
    }
    s_State.faults.erase(s_State.faults.begin());
    s_State.calls = 0;
    return fault.result;
}

} // namespace

VkResult FailureOf(const std::string& name, Errors errors)
{
    const std::scoped_lock lock(s_Mutex);
    errors.insert(errors.end(), {VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY});
    s_State.all.emplace_back(name, errors);
    const auto may = [&](VkResult result)
    {
        return std::find(errors.begin(), errors.end(), result) != errors.end();
    };
    if (s_State.lost && may(VK_ERROR_DEVICE_LOST) && name != "vkCreateDevice")
    {
        return VK_ERROR_DEVICE_LOST;
    }
    const bool mayFail = s_State.function.empty()
                             ? !s_State.faults.empty() && may(s_State.faults.front().result)
                             : name == s_State.function;
    const VkResult failure = NextFailure(mayFail);
    if (failure != VK_SUCCESS)
    {
        s_State.failed.push_back({name, failure});
        s_State.lost = failure == VK_ERROR_DEVICE_LOST && name != "vkCreateDevice";
    }
    return failure;
}

void FailCalls(std::vector<Fault> faults)
{
    FailNothing();
    s_State.faults = std::move(faults);
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
    s_State.faults.clear();
    s_State.function.clear();
    s_State.failed.clear();
    s_State.calls = 0;
    s_State.all.clear();
}

const std::vector<Failed>& FailedCalls()
{
    return s_State.failed;
}

std::string FailedFunction()
{
    return s_State.failed.empty() ? "" : s_State.failed.front().function;
}

std::vector<std::string> CallsThatMay(VkResult result)
{
    std::vector<std::string> calls;
    for (const auto& [function, errors] : s_State.all)
    {
        if (std::find(errors.begin(), errors.end(), result) != errors.end())
        {
            calls.push_back(function);
        }
    }
    return calls;
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

std::uint32_t MemoryTypeCount()
{
    return s_State.memoryTypes;
}

void SetTool(bool isThere)
{
    s_State.hasTool = isThere;
}

bool Covers(const std::string& function)
{
    const std::initializer_list<std::string> askedFor = {"vkSetDebugUtilsObjectNameEXT",
                                                         "vkCreateDebugUtilsMessengerEXT"};
    return std::find(askedFor.begin(), askedFor.end(), function) != askedFor.end() ||
           dlsym(RTLD_DEFAULT, function.c_str()) != dlsym(RTLD_NEXT, function.c_str());
}

} // namespace limn::test::faulty_loader
