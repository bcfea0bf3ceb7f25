#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace limn
{

/// Where the first outermost `[...]` or `{...}` begins that is longer than `maxBytes`. Block
/// scalars are looked into as if they were YAML, so text in one may count.
std::optional<std::size_t> FindLongFlow(std::string_view text, std::size_t maxBytes);

} // namespace limn
