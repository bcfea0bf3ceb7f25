#pragma once

#include <cstdint>
#include <string_view>

namespace limn
{

/// Returns a hash of the bytes, which is the same everywhere and always. It is never 0, which can
/// stand for an absent file. It is no defence against somebody who wants equal hashes.
std::uint64_t HashContent(std::string_view bytes);

} // namespace limn
