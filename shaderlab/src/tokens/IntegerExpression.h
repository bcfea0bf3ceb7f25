#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace limn
{

/// The macros without arguments, or constants: name → text of the value.
using IntegerNames = std::map<std::string, std::string, std::less<>>;

/// Returns the value of a constant expression such as that of `#if`. Unknown names are 0, as in C;
/// so are invalid expressions, which the compiler reports. Takes bounded time, whatever the text.
std::int64_t EvaluateInteger(std::string_view expression, const IntegerNames& names);

} // namespace limn
