#pragma once

#include "console/Console.h"

#include <string>
#include <vector>

namespace limn
{

/// `limn set`, as the command line has it.
struct SetOptions
{
    std::string file;                 ///< a profile of limn's or of Unity's form
    std::vector<std::string> edits;   ///< "Component.param=value"
    std::vector<std::string> plugins; ///< modules with features of other people
};

/// Changes values of a profile file in place, all of them or none, and prints what they were.
/// @return an ExitCode
/// @throws AssetError as SetScalars does
int RunSet(const SetOptions& options, Console& console);

} // namespace limn
