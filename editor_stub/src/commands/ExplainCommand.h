#pragma once

#include "console/Console.h"

#include <map>
#include <string>
#include <vector>

namespace limn
{

/// `limn explain`, as the command line has it.
struct ExplainOptions
{
    std::string scene;
    std::string object; ///< "": all
    bool json = false;
    std::string graph; ///< file for the frame as a picture; "": none
    std::string profile;
    std::vector<std::string> overrides;
    std::map<std::string, std::string> packages;
    std::vector<std::string> plugins; ///< modules with features of other people
    std::vector<std::string> roots;
};

/// Says what a scene's frame draws and why: volume values, passes, textures, variants, objects.
/// @return an ExitCode
/// @throws AssetError, also if the scene has no object of that name with a mesh
int RunExplain(const ExplainOptions& options, Console& console);

} // namespace limn
