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

void detail::TellOfFeatureCode(const FeatureCode& code)
{
    if (const FeatureCodeListener listener = s_FeatureCodeListener)
    {
        listener(code);
    }
}

} // namespace limn
