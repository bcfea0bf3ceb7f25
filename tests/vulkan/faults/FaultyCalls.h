#pragma once

#include "faults/FaultyLoader.h"

#include <dlfcn.h>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace limn::test::faulty_loader
{

using Errors = std::vector<VkResult>;

// What the entry points share with those who say what is to fail.

struct State
{
    // What is to fail:
    std::vector<Fault> faults; ///< that are yet to come
    std::string function;      ///< whose calls all fail with `result`, but the first `spared`
    int spared = 0;
    VkResult result = VK_SUCCESS;
    // What happened:
    int calls = 0; ///< that might have failed since the last one that did
    std::vector<std::pair<std::string, Errors>> all; ///< calls, and what they may return
    std::vector<Failed> failed;
    bool lost = false;
    std::map<std::string, int> objects;
    bool hasTool = false;
    std::uint32_t storageLimit = 0;
    std::uint32_t uniformLimit = 0;
    VkDeviceSize largestStorage = 0;
    std::uint32_t memoryTypes = 0; ///< of the device that was asked last
    // Entry points that are asked for by name, which differ with the layers:
    std::map<VkDevice, PFN_vkSetDebugUtilsObjectNameEXT> setObjectName;
    std::map<VkInstance, PFN_vkCreateDebugUtilsMessengerEXT> createMessenger;
    std::map<VkInstance, PFN_vkDestroyDebugUtilsMessengerEXT> destroyMessenger;
};
extern State s_State;
/// Guards it: limn compiles pipelines on several threads. Drivers call nothing of this.
extern std::mutex s_Mutex;

/// Returns what a call is to return instead of being handed on; VK_SUCCESS = it is handed on.
/// @param errors  what it may return, besides the errors of memory, which each may
VkResult FailureOf(const std::string& name, Errors errors);

/// The loader's own entry point.
template <typename Function>
Function* Next(const char* name)
{
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

template <typename Function, typename... Arguments>
VkResult Call(Function* next, const char* name, const Errors& errors, Arguments... arguments)
{
    const VkResult failure = FailureOf(name, errors);
    return failure == VK_SUCCESS ? next(arguments...) : failure;
}

/// A call that fills a list and may return VK_INCOMPLETE, which it does where the list is said to
/// be one element shorter than it is.
template <typename Count, typename Element, typename Next>
VkResult CallList(const char* name, Errors errors, Count* count, const Element* list, Next&& next)
{
    if (list != nullptr && *count > 0)
    {
        errors.push_back(VK_INCOMPLETE);
    }
    const VkResult failure = FailureOf(name, errors);
    *count -= failure == VK_INCOMPLETE ? 1 : 0;
    return failure == VK_SUCCESS || failure == VK_INCOMPLETE ? next() : failure;
}

inline void Made(const char* kind, VkResult result)
{
    const std::scoped_lock lock(s_Mutex);
    s_State.objects[kind] += result == VK_SUCCESS ? 1 : 0;
}

template <typename Handle>
void Destroyed(const char* kind, Handle handle)
{
    const std::scoped_lock lock(s_Mutex);
    s_State.objects[kind] -= handle == VK_NULL_HANDLE ? 0 : 1;
}

/// The loader's entry point and its name.
#define LIMN_NEXT(function) Next<decltype(function)>(#function), #function

} // namespace limn::test::faulty_loader
