#pragma once

#include "selection/SceneSelection.h"

#include <map>
#include <string>
#include <vector>

namespace limn
{

/// `limn render`, as the command line has it.
struct RenderOptions
{
    std::string scene;
    std::string output;
    int width = 0; ///< 0: the scene's
    int height = 0;
    double time = 0.0; ///< seconds
    int frames = 1;
    std::string profile;
    std::vector<std::string> overrides;
    std::vector<SelectionStep> selection;
    std::string device;
    bool validate = false;
    std::string statsFile;
    std::string traceFile;
    std::string cacheFolder; ///< "": the default one
    bool noCache = false;
    std::map<std::string, std::string> packages;
    std::vector<std::string> plugins; ///< modules with features of other people
    std::vector<std::string> roots;   ///< folders that references and includes may lead into
};

} // namespace limn
