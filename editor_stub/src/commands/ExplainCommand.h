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
    std::string pixel;  ///< as ParsePixel takes it; "": none is asked about
    std::string device; ///< that draws where a pixel is asked about
    bool json = false;
    std::string graph; ///< file for the frame as a picture; "": none
    std::string profile;
    std::vector<std::string> overrides;
    std::map<std::string, std::string> packages;
    std::vector<std::string> plugins; ///< modules with features of other people
    std::vector<std::string> roots;
};

/// Prints what a scene's frame draws and why: volume values, passes, textures, variants, objects;
/// or what becomes of the draws at one pixel.
/// @return an ExitCode
/// @throws AssetError, also if the scene has no object of that name with a mesh
/// @throws VulkanError where a pixel is asked about
int RunExplain(const ExplainOptions& options, Console& console);

} // namespace limn
