#pragma once

#include <string_view>
#include <typeinfo>

namespace limn
{

/// Hears of an exception that the code of a feature or a pass let out, while it is being handled:
/// it can throw another one in its place, which says whose code it is.
/// @param type    of the feature or pass; in the module that defines it
/// @param name    the feature's, or the pass's profilingSampler's
/// @param member  "AddRenderPasses", "Execute" ...
using FeatureCodeListener = void (*)(const std::type_info& type, std::string_view name,
                                     const char* member);

/// @param listener  in place of the one before; null = nobody
void SetFeatureCodeListener(FeatureCodeListener listener);

namespace detail
{
void TellOfFeatureCode(const std::type_info& type, std::string_view name, const char* member);
}

/// Calls `work`, which calls `member` of `object`; an exception goes through the listener.
template <typename Object, typename Work>
decltype(auto) RunFeatureCode(const Object& object, std::string_view name, const char* member,
                              Work&& work)
{
    try
    {
        return work();
    }
    catch (...)
    {
        detail::TellOfFeatureCode(typeid(object), name, member);
        throw;
    }
}

} // namespace limn
