#pragma once

#include "console/Console.h"
#include "selection/SceneSelection.h"

#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/VolumeManager.h>
#include <map>
#include <string>
#include <vector>

namespace limn
{

/// `limn render`, as the command line has it.
struct RenderOptions
{
    std::string scene;
    std::string sceneInProject; ///< of --scene, until it is joined to `scene`
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

/// The compiler's options for `options`; its cache folder is made. A default folder that cannot be
/// made is a note, not an error.
/// @throws AssetError if the folder the user named cannot be made
ShaderCompilerOptions ChooseCompilerOptions(const RenderOptions& options, Console& console);

/// The scene with the command line's profile, values, size and selection.
/// @throws AssetError
SceneAsset LoadForRendering(const RenderOptions& options, AssetContext& assets);

/// A screen shows no alpha; what blending left there would make a PNG see-through.
void MakeOpaque(Image& image);

/// A loaded scene with all that drawing it takes but the device: renderer and volumes.
class SceneView
{
public:
    /// Creates the features.
    /// @lifetime  keeps `assets` by reference
    SceneView(SceneAsset asset, const AssetContext& assets);

    /// Blends the volumes as they are now and draws.
    /// @param time    seconds, what _Time shows and where turning objects are
    /// @param isLast  nothing is drawn after this: what only a next frame could read is left out
    /// @param timeline  gets how long the phases take; may be null
    RenderResult Render(UniversalRenderPipeline& pipeline, double time, bool isLast = false,
                        Timeline* timeline = nullptr);
    /// Does the same into a result that is used again, by a request in which all but the scene and
    /// its volumes is the caller's.
    void Render(UniversalRenderPipeline& pipeline, RenderRequest& request, RenderResult& result);

    SceneAsset& asset() { return m_Asset; } ///< without its features

    bool leavesOut = true; ///< see FrameCompilerOptions

private:
    SceneAsset m_Asset;
    UniversalRenderer m_Renderer;
    VolumeManager m_Volumes;
    VolumeStack m_Stack;
    bool m_HasEnvironment = false; ///< the scene has the light of its sky
};

} // namespace limn
