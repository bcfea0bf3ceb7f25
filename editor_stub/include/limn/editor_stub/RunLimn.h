#pragma once

#include <iosfwd>
#include <span>
#include <string>

namespace limn
{

/// The exit codes of `limn`.
enum class ExitCode
{
    Done = 0,
    BadInput = 1,   ///< a file is wrong or cannot be written; every problem was printed
    WrongUsage = 2, ///< the command line makes no sense
    MachineLacksIt =
        3, ///< there is no usable Vulkan device or it fails, no memory, or no room for the results
    Bug = 70, ///< limn has a bug; EX_SOFTWARE of sysexits.h
};

/// Runs one verb of the command line `limn`. Results go to `out`, everything else to `err`. Throws
/// nothing: whatever goes wrong is printed.
/// @param args  the words behind the program's name
/// @return an ExitCode
int RunLimn(std::span<const std::string> args, std::ostream& out, std::ostream& err);

} // namespace limn
