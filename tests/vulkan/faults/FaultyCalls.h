#pragma once

#include "faults/FaultyLoader.h"

#include <dlfcn.h>
#include <initializer_list>
#include <map>
#include <string>

namespace limn::test::faulty_loader
{

// What the entry points share with those who say what is to fail.

struct State
{
    // What is to fail:
    int number = 0; ///< of the calls that may fail with `result`, 0 = by `function`
    std::string function;
    int spared = 0;
    VkResult result = VK_SUCCESS; ///< VK_SUCCESS = nothing
    // What happened:
    int calls = 0;
    std::string failed;
    bool lost = false;
    std::map<std::string, int> objects;
    std::uint32_t storageLimit = 0;
    std::uint32_t uniformLimit = 0;
    VkDeviceSize largestStorage = 0;
    // Entry points that are asked for by name, which differ with the layers:
    std::map<VkDevice, PFN_vkSetDebugUtilsObjectNameEXT> setObjectName;
    std::map<VkInstance, PFN_vkCreateDebugUtilsMessengerEXT> createMessenger;
    std::map<VkInstance, PFN_vkDestroyDebugUtilsMessengerEXT> destroyMessenger;
};
extern State s_State; // one thread at a time calls limn's device, and drivers call nothing of this

using Errors = std::initializer_list<VkResult>;

/// What a call is to return instead of being handed on; VK_SUCCESS = it is handed on.
/// @param errors  it may return, besides those of memory, which each may
VkResult FailureOf(const std::string& name, Errors errors);

/// The loader's own entry point.
template <typename Function>
Function* Next(const char* name)
{
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

template <typename Function, typename... Arguments>
VkResult Call(Function* next, const char* name, Errors errors, Arguments... arguments)
{
    const VkResult failure = FailureOf(name, errors);
    return failure == VK_SUCCESS ? next(arguments...) : failure;
}

inline void Made(const char* kind, VkResult result)
{
    s_State.objects[kind] += result == VK_SUCCESS ? 1 : 0;
}

template <typename Handle>
void Destroyed(const char* kind, Handle handle)
{
    s_State.objects[kind] -= handle == VK_NULL_HANDLE ? 0 : 1;
}

/// The loader's entry point and its name.
#define LIMN_NEXT(function) Next<decltype(function)>(#function), #function

} // namespace limn::test::faulty_loader
