#pragma once

#include <cstddef>
#include <ostream>

namespace limn
{

enum class ColorMode
{
    Auto, ///< on a terminal that supports colours, unless NO_COLOR is set to anything
    Always,
    Never
};

/// Returns whether the stream is std::cout or std::cerr and leads to a terminal.
bool isTerminal(const std::ostream& stream);

/// Returns the number of columns that people read the stream in: the variable COLUMNS, else the
/// width of its terminal, else 80.
std::size_t TerminalWidth(const std::ostream& stream);

/// Returns the number of lines of the stream's terminal: the variable LINES, else the terminal's
/// own, else 24.
std::size_t TerminalHeight(const std::ostream& stream);

/// Returns whether the terminal supports no commands: no colours, and no lines that are replaced.
bool isDumbTerminal();

bool usesColor(ColorMode mode, const std::ostream& stream);

} // namespace limn
