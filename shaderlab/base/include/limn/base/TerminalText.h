#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace limn
{

/// Returns names, values and paths in a form that is safe in one line of a terminal. Commands of
/// the terminal, line ends, changes of the writing direction, invisible characters, and bytes that
/// are no UTF-8 are written as `\n`, `\x1B` or `\u202E`: no name in a file can forge a message.
std::string OneLine(std::string_view text);

/// Returns a message like OneLine; words of more than 256 bytes are Shortened.
std::string Sentence(std::string_view text);

/// Returns a text of several lines like OneLine; line breaks and tabs stay. JSON that is UTF-8
/// stays the same JSON.
std::string SeveralLines(std::string_view text);

/// Returns the text if it has at most `most` bytes. Otherwise returns its beginning and its end
/// with "…" between them, about `most` bytes together. No character of UTF-8 is cut.
std::string Shortened(std::string_view text, std::size_t most);

/// Returns the number of bytes of the UTF-8 character that a text begins with. Returns 0 if the
/// text is empty, if that is no character, or if it must not reach a terminal unchanged.
std::size_t PrintableSize(std::string_view text);

/// A character of UTF-8.
struct DecodedCharacter
{
    std::uint32_t code = 0;
    std::size_t size = 0; ///< in bytes; 0: not UTF-8
};

/// Returns the character that a text begins with.
DecodedCharacter DecodeCharacter(std::string_view text);

} // namespace limn
