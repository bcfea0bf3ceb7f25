#pragma once

#include <cstdint>
#include <string_view>

namespace limn
{

/// The same number for the same bytes wherever and whenever, never 0, which can stand for an absent
/// file. No defence against who wants equal numbers.
std::uint64_t HashContent(std::string_view bytes);

} // namespace limn
