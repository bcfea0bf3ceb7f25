#pragma once

#include "console/Console.h"

#include <string>
#include <vector>

namespace limn
{

/// `limn inspect`, as the command line has it.
struct InspectOptions
{
    std::string file; ///< a scene, a profile, or a renderer, pipeline or material of Unity's
    bool json = false;
    std::vector<std::string> plugins; ///< modules with features of other people
    std::vector<std::string> roots;
};

/// Prints what the file sets: the parameters of volumes' components and the settings of features,
/// each with value, default and range. Needs no device and compiles nothing.
/// @return ExitCode::Done
/// @throws AssetError
int RunInspect(const InspectOptions& options, Console& console);

} // namespace limn
