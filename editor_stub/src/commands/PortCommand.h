#pragma once

#include "console/Console.h"

#include <string>
#include <vector>

namespace limn
{

/// `limn port`, as the command line has it.
struct PortOptions
{
    std::vector<std::string> files; ///< C#, not empty
    std::string folder;             ///< made, if it is not there
};

/// Writes the folder of a plug-in in which a render feature of Unity's is begun in C++, and says
/// what of the C# limn does not have or know.
/// @return an ExitCode
/// @throws AssetError if a file is no C#, none has a feature, or the folder cannot be written
int RunPort(const PortOptions& options, Console& console);

} // namespace limn
