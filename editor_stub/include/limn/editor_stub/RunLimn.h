#pragma once

#include <iosfwd>
#include <span>
#include <string>

namespace limn
{

/// What `limn` ends with.
enum class ExitCode
{
    Done = 0,
    BadInput = 1,   ///< a file is wrong or cannot be written; every problem was printed
    WrongUsage = 2, ///< the command line makes no sense
    MachineLacksIt =
        3,    ///< no usable Vulkan device or one that fails, no memory, no room for the results
    Bug = 70, ///< limn is wrong; EX_SOFTWARE of sysexits.h
};

/// The command line `limn`: runs one verb. Results go to `out`, everything else to `err`. Throws
/// nothing: whatever goes wrong is printed.
/// @param args  what follows the program's name
/// @return an ExitCode
int RunLimn(std::span<const std::string> args, std::ostream& out, std::ostream& err);

} // namespace limn
