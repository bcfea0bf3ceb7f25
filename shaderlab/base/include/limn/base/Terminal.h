#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>

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

/// Returns the command of the pager, the program in which people read long texts: the variable
/// LIMN_PAGER, else PAGER, else `less` where it is installed. Returns "" if the variable is empty
/// or "cat", which means none.
std::string PagerCommand();

/// Runs a pager on this process's terminal with `text` as its input, and waits for its end. Unless
/// the variable LESS is set, `less` starts with -FRX, as git starts it. A pager that ends before it
/// has read everything is no error. Ctrl-C is the pager's meanwhile.
/// @param command  a command of the shell
/// @return false if there is no such program, which the shell has reported; nothing was shown
bool ShowInPager(const std::string& command, std::string_view text);

} // namespace limn
