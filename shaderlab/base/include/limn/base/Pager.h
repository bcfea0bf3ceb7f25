#pragma once

#include <string>
#include <string_view>

namespace limn
{

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
