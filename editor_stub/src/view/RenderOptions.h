#pragma once

#include "console/Console.h"
#include "selection/SceneSelection.h"

#include <limn/editor_stub/SceneFile.h>
#include <map>
#include <string>
#include <vector>

namespace limn
{

/// The arguments of `limn render`.
struct RenderOptions
{
    std::string scene;
    std::string sceneInProject; ///< the value of --scene, until it is joined to `scene`
    std::string output;
    int width = 0; ///< 0 for the scene's own width
    int height = 0;
    double time = 0.0; ///< seconds
    int frames = 1;
    std::string profile;
    std::vector<std::string> overrides;
    std::vector<SelectionStep> selection;
    std::string device;
    bool validate = false;
    bool showsVolumes = false; ///< see DrawVolumes
    std::string statsFile;
    std::string traceFile;
    std::string cacheFolder; ///< "" for the default folder
    bool noCache = false;
    std::map<std::string, std::string> packages;
    std::vector<std::string> plugins; ///< modules with features of other people
    std::vector<std::string> roots;   ///< folders that references and includes may lead into
};

/// Returns the compiler's options for `options`, and makes its cache folder. If the default folder
/// cannot be made, that is a note, not an error.
/// @throws AssetError if a folder that the user named cannot be made
ShaderCompilerOptions ChooseCompilerOptions(const RenderOptions& options, Console& console);

/// Loads the scene with the command line's profile, values, size and selection.
/// @throws AssetError
SceneAsset LoadForRendering(const RenderOptions& options, AssetContext& assets);

} // namespace limn
