#include <atomic>

#include <cstdlib>
#include <cxxabi.h>
#include <limn/core/PluginCallSite.h>
#include <memory>

namespace limn
{

namespace
{

std::atomic<PluginCodeListener> s_PluginCodeListener{nullptr};

} // namespace

void SetPluginCodeListener(PluginCodeListener listener)
{
    s_PluginCodeListener = listener;
}

void detail::TellOfPluginCode(const PluginCallSite& code)
{
    if (const PluginCodeListener listener = s_PluginCodeListener)
    {
        listener(code);
    }
}

std::string TypeName(std::type_index type)
{
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> demangled(
        abi::__cxa_demangle(type.name(), nullptr, nullptr, &status), std::free);
    std::string name = demangled ? demangled.get() : type.name();
    constexpr std::string_view k_Anonymous = "(anonymous namespace)::";
    for (auto at = name.find(k_Anonymous); at != name.npos; at = name.find(k_Anonymous))
    {
        name.erase(at, k_Anonymous.size());
    }
    constexpr std::string_view prefix = "limn::";
    return name.starts_with(prefix) ? name.substr(prefix.size()) : name;
}

} // namespace limn
