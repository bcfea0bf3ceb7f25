#pragma once

#include <cstddef>
#include <limn/base/Diagnostic.h>
#include <optional>
#include <string_view>

namespace limn
{

/// The offset of the first byte that does not belong to well-formed UTF-8 text, NUL included.
std::optional<std::size_t> FindNonText(std::string_view text);

/// The place of a byte, lines ended by \n and counted from `firstLine`.
SourceLocation LocationOf(std::string_view text, std::size_t offset, int firstLine = 1);

/// Whether the quoted scalar that begins at `offset`, perhaps with a tag or an anchor, ends in this
/// text; true for what is not in quotes.
bool IsQuoteClosed(std::string_view text, std::size_t offset);

/// Where the first outermost `[...]` or `{...}` begins that is longer than `maxBytes`. Block
/// scalars are looked into as if they were YAML, so text in one may count.
std::optional<std::size_t> FindLongFlow(std::string_view text, std::size_t maxBytes);

} // namespace limn
