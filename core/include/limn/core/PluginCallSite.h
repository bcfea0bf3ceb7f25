#pragma once

#include <string>
#include <string_view>
#include <typeindex>
#include <typeinfo>
#include <utility>

namespace limn
{

/// Returns a type's name as C++ writes it, without the namespace limn.
std::string TypeName(std::type_index type);

/// A call into the code of the author of a feature, a pass or a volume component.
struct PluginCallSite
{
    const std::type_info& type; ///< the type that has the member, in the module that defines it
    /// The name of the feature, or of the pass's profilingSampler; "" = none.
    std::string_view name;
    const char* member; ///< "AddRenderPasses", "Execute" ...
    /// The feature that enqueued the pass, if the call is a pass's and the feature is known. It
    /// lives during the call.
    std::string_view featureOfPass = {};
    const std::type_info* typeOfFeature = nullptr; ///< null if featureOfPass is not known
};

/// Receives an exception that left an author's code, while it is being handled. It can throw
/// another one in its place, which names the code.
using PluginCodeListener = void (*)(const PluginCallSite& code);

/// Sets the listener of all calls.
/// @param listener  replaces the listener before it; null = none
void SetPluginCodeListener(PluginCodeListener listener);

namespace detail
{
void TellOfPluginCode(const PluginCallSite& code);
}

/// Calls `work`, which is an author's code; the listener receives its exceptions.
template <typename Work>
decltype(auto) RunPluginCode(const std::type_info& type, std::string_view name, const char* member,
                             Work&& work)
{
    try
    {
        return std::forward<Work>(work)();
    }
    catch (...)
    {
        detail::TellOfPluginCode({type, name, member});
        throw;
    }
}

} // namespace limn
