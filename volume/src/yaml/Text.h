#pragma once

#include <cstddef>
#include <limn/volume/YamlNode.h>
#include <optional>
#include <string>
#include <string_view>

namespace limn
{

/// Returns the offset of the first byte that does not belong to well-formed UTF-8 text; NUL does
/// not belong to it.
std::optional<std::size_t> FindNonText(std::string_view text);

/// Returns the place of a byte. Lines end with \n and are counted from `firstLine`.
SourceLocation LocationOf(std::string_view text, std::size_t offset, int firstLine = 1);

/// Returns whether the quoted scalar that begins at `offset`, perhaps with a tag or an anchor, ends
/// in this text. Returns true if there are no quotes.
bool IsQuoteClosed(std::string_view text, std::size_t offset);

/// Returns the text behind the tags and anchors with which it begins.
std::string_view WithoutMarks(std::string_view text);

/// Returns the text in quotes of this kind, as YAML reads it.
std::string InQuotes(const std::string& text, char quote);

/// Returns the offset of the first outermost `[...]` or `{...}` that is longer than `maxBytes`.
/// Block scalars are read as if they were YAML, so text in one may count.
std::optional<std::size_t> FindLongFlow(std::string_view text, std::size_t maxBytes);

} // namespace limn
