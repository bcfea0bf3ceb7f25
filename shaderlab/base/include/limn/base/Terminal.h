#pragma once

#include <cstddef>
#include <ostream>

namespace limn
{

enum class ColorMode
{
    Auto, ///< on a terminal that can, unless NO_COLOR is set to anything
    Always,
    Never
};

/// Whether the stream is std::cout or std::cerr and leads to a terminal.
bool isTerminal(const std::ostream& stream);

/// Columns of the terminal that the stream leads to; 80 where it leads to none.
std::size_t TerminalWidth(const std::ostream& stream);

/// Whether a terminal takes commands: colours, and lines that are replaced.
bool isDumbTerminal();

bool usesColor(ColorMode mode, const std::ostream& stream);

} // namespace limn
