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

/// Makes an image opaque. A screen shows no alpha, but alpha that blending left would make a PNG
/// see-through.
void MakeOpaque(Image& image);

/// Returns the notes of a frame, each once, and one more if objects were asked about and none was
/// drawn.
std::vector<std::string> NotesOf(const RenderReport& report);

/// A loaded scene with everything that is needed to draw it except the device: renderer and
/// volumes.
class SceneView
{
public:
    /// Creates the features.
    /// @lifetime  keeps `assets` by reference
    SceneView(SceneAsset asset, const AssetContext& assets);

    /// Blends the volumes as they are now and draws.
    /// @param time    in seconds, for _Time and for objects that turn
    /// @param isLast  nothing is drawn after this, so what only a next frame could read is left out
    /// @param timeline  receives the times of the phases; may be null
    RenderResult Render(UniversalRenderPipeline& pipeline, double time, bool isLast = false,
                        Timeline* timeline = nullptr);
    /// Does the same into a result that is reused. In the request, everything but the scene and its
    /// volumes is the caller's.
    void Render(UniversalRenderPipeline& pipeline, RenderRequest& request, RenderResult& result);

    SceneAsset& asset() { return m_Asset; } ///< without its features

    bool leavesOut = true; ///< see FrameCompilerOptions

private:
    SceneAsset m_Asset;
    UniversalRenderer m_Renderer;
    VolumeManager m_Volumes;
    VolumeStack m_Stack;
    bool m_HasEnvironment = false; ///< true if the scene has the light of its sky
};

} // namespace limn
