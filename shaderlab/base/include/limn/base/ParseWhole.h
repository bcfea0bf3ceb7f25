#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace limn
{

/// Returns the number that the whole text is, or nothing if it is none.
template <typename Number>
std::optional<Number> ParseWhole(std::string_view text)
{
    Number number{};
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc{} && rest == end ? std::optional(number) : std::nullopt;
}

} // namespace limn
