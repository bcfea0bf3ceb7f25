#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace limn
{

/// Macros without arguments, or constants: name → text of the value.
using IntegerNames = std::map<std::string, std::string, std::less<>>;

/// The value of a constant expression such as `#if` takes. Unknown names are 0, as in C; so is what
/// makes no sense, for the compiler reports that. Bounded time, whatever the text.
std::int64_t EvaluateInteger(std::string_view expression, const IntegerNames& names);

} // namespace limn
