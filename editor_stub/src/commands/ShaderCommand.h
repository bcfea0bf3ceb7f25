#pragma once

#include "console/Console.h"

#include <map>
#include <string>
#include <vector>

namespace limn
{

/// `limn shader`, as the command line has it.
struct ShaderOptions
{
    std::vector<std::string> paths;    ///< files, and folders for the .shader files below them;
                                       ///< or .compute files
    std::string emit;                  ///< "", "spirv", "glsl", "glsles", "msl" or "hlsl"
    std::string outputFolder;          ///< of what is emitted
    std::vector<std::string> keywords; ///< on; empty = those of a new material
    int jobs = 0;                      ///< threads; 0 = one a core
    bool parseOnly = false;
    bool variants = false; ///< count them, compile nothing
    bool print = false;    ///< the files as canonical text, nothing else
    bool json = false;
    std::map<std::string, std::string> packages;
    std::vector<std::string> roots;
};

/// Checks ShaderLab files and describes them; compiles the kernels of .compute files.
/// @return an ExitCode: BadInput if a file has an error
/// @throws AssetError if a path is missing or something cannot be written
int RunShader(const ShaderOptions& options, Console& console);

} // namespace limn
