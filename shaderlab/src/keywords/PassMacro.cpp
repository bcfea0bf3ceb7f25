#include "keywords/PassMacro.h"

#include <limn/base/Case.h>

#include <algorithm>
#include <utility>

namespace limn
{

std::string_view PassMacro(std::string_view lightMode)
{
    static constexpr std::pair<std::string_view, std::string_view> k_Macros[] = {
        {"ForwardBase", "UNITY_PASS_FORWARDBASE"},
        {"ForwardAdd", "UNITY_PASS_FORWARDADD"},
        {"Deferred", "UNITY_PASS_DEFERRED"},
        {"PrepassBase", "UNITY_PASS_PREPASSBASE"},
        {"PrepassFinal", "UNITY_PASS_PREPASSFINAL"},
        {"ShadowCaster", "UNITY_PASS_SHADOWCASTER"},
        {"Meta", "UNITY_PASS_META"},
        {"MotionVectors", "UNITY_PASS_MOTIONVECTORS"}};
    const auto* const found = std::ranges::find_if(
        k_Macros, [&](const auto& item) { return EqualsIgnoringCase(item.first, lightMode); });
    return found == std::end(k_Macros) ? std::string_view() : found->second;
}

} // namespace limn
