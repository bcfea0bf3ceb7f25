#pragma once

#include <string_view>

namespace limn
{

/// What the macros begin with that tell a program what kind of pass it is.
inline constexpr std::string_view k_PassMacroStart = "UNITY_PASS_";

/// The macro that Unity's compiler defines for passes of a LightMode tag; "" of those that render
/// pipelines make up.
std::string_view PassMacro(std::string_view lightMode);

} // namespace limn
