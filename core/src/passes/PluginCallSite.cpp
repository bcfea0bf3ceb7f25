#include <atomic>
#include <limn/core/PluginCallSite.h>

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

} // namespace limn
