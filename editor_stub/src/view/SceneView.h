#pragma once

#include "console/Console.h"
#include "view/RenderOptions.h"

#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/VolumeManager.h>

namespace limn
{

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

    bool leavesOut = true; ///< see FrameCompilerOptions

private:
    SceneAsset m_Asset;
    UniversalRenderer m_Renderer;
    VolumeManager m_Volumes;
    VolumeStack m_Stack;
};

} // namespace limn
