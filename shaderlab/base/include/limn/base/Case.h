#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace limn
{

// These functions handle only ASCII, whatever the locale, which is all that ShaderLab, HLSL
// semantics and the names of values in files need.

constexpr char ToLower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string ToLower(std::string_view text)
{
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](char c) { return ToLower(c); });
    return result;
}

constexpr bool EqualsIgnoringCase(std::string_view a, std::string_view b)
{
    return std::ranges::equal(a, b, [](char x, char y) { return ToLower(x) == ToLower(y); });
}

} // namespace limn
