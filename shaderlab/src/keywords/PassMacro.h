#pragma once

#include <string_view>

namespace limn
{

/// The beginning of the macros that tell a program its kind of pass.
inline constexpr std::string_view k_PassMacroStart = "UNITY_PASS_";

/// Returns the macro that Unity's compiler defines for passes with a LightMode tag, or "" for tags
/// that render pipelines invent.
std::string_view PassMacro(std::string_view lightMode);

} // namespace limn
