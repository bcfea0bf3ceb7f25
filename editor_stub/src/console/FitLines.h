#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace limn
{

/// Returns the number of columns that a line takes on a terminal: one a character, none for the
/// codes of colours.
std::size_t ColumnsOf(std::string_view line);

/// Returns a text of several lines for a terminal of `width` columns. A line that is too long goes
/// on in the next one, below its second column if it has columns (two or more blanks stand between
/// them), else two columns right of its beginning. In rows of one table that are too long the
/// columns behind the second move together first. Words longer than the width, such as paths, stay
/// whole, so that they can be copied.
std::string FitLines(std::string_view text, std::size_t width);

/// Returns the words in lines of `width` columns, with an end of line. All lines but the first
/// begin with `hang` blanks.
/// @param column  the column at which the first line begins
std::string Wrapped(std::string_view words, std::size_t column, std::size_t hang,
                    std::size_t width);

/// Returns the beginning of a line that takes at most `width` columns, with "…" where it ends if it
/// is not the whole line.
std::string CutLine(std::string_view line, std::size_t width);

} // namespace limn
