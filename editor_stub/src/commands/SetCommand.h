#pragma once

#include "console/Console.h"

#include <string>
#include <vector>

namespace limn
{

/// `limn set`, as the command line has it.
struct SetOptions
{
    std::string file;               ///< a scene, or a profile or renderer of limn's or Unity's form
    std::vector<std::string> edits; ///< "NAME.path=value"
    std::vector<std::string> plugins; ///< modules with features of other people
};

/// Changes a profile's parameters, or the settings of a scene's or renderer's features, in place,
/// all of them or none, and prints what they were.
/// @return an ExitCode
/// @throws AssetError as SetScalars and SetFeatureSettings do
int RunSet(const SetOptions& options, Console& console);

} // namespace limn
