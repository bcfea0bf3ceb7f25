#include <atomic>
#include <limn/core/FeatureCode.h>

namespace limn
{

namespace
{

std::atomic<FeatureCodeListener> s_FeatureCodeListener{nullptr};

} // namespace

void SetFeatureCodeListener(FeatureCodeListener listener)
{
    s_FeatureCodeListener = listener;
}

void detail::TellOfFeatureCode(const std::type_info& type, std::string_view name,
                               const char* member)
{
    if (const FeatureCodeListener listener = s_FeatureCodeListener)
    {
        listener(type, name, member);
    }
}

} // namespace limn
