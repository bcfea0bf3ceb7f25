#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace limn
{

/// Names, values and paths as one line of a terminal may have them: what a terminal would take for
/// a command or a line's end, what turns the direction of writing, what is nowhere to be seen, and
/// what is no UTF-8 is written
/// as \n, \x1B or \u202E. So no name in a file can forge a message.
std::string OneLine(std::string_view text);

/// OneLine of a message; words of more than 256 bytes are Shortened.
std::string Sentence(std::string_view text);

/// OneLine for text that has several lines: line breaks and tabs stay. JSON that is UTF-8 stays the
/// same JSON.
std::string SeveralLines(std::string_view text);

/// The text where it has at most `most` bytes, else its beginning and its end with "…" between
/// them, about `most` bytes of both together. No character of UTF-8 is cut.
std::string Shortened(std::string_view text, std::size_t most);

/// Bytes of the character of UTF-8 that a text begins with; 0 for an empty text, where that is no
/// character, and for one that must not reach a terminal as it is.
std::size_t PrintableSize(std::string_view text);

} // namespace limn
