#pragma once

#include <string>
#include <string_view>
#include <typeindex>
#include <typeinfo>
#include <utility>

namespace limn
{

/// A type's name as C++ writes it, without the namespace limn.
std::string TypeName(std::type_index type);

/// A call into the code of whoever wrote a feature, a pass or a volume component.
struct PluginCallSite
{
    const std::type_info& type; ///< whose member it is; in the module that defines the type
    std::string_view name;      ///< the feature's, or the pass's profilingSampler's; "" = none
    const char* member;         ///< "AddRenderPasses", "Execute" ...
    /// That enqueued the pass, if it is one's and that is known. Lives during the call.
    std::string_view featureOfPass = {};
    const std::type_info* typeOfFeature = nullptr; ///< null where featureOfPass is not known
};

/// Hears of an exception that such code let out, while it is being handled: it can throw another
/// one in its place, which says whose code it is.
using PluginCodeListener = void (*)(const PluginCallSite& code);

/// @param listener  in place of the one before; null = nobody
void SetPluginCodeListener(PluginCodeListener listener);

namespace detail
{
void TellOfPluginCode(const PluginCallSite& code);
}

/// Calls `work`, which is such code; an exception goes through the listener.
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
