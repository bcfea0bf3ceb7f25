#pragma once

#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/VolumeManager.h>
#include <string>
#include <vector>

namespace limn
{

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
    /// Draws, with the scene in the request.
    void Draw(UniversalRenderPipeline& pipeline, const RenderRequest& request,
              RenderResult& result);
    /// In a scene of Unity's, leaves out the features or shaders that a frame has ended with.
    /// @return the errors; none if nothing could be left out
    std::vector<Diagnostic> LeaveOut(const AssetError& error);
    /// Draws the textures that the picture reads.
    std::vector<RenderResult> RenderTextures(UniversalRenderPipeline& pipeline,
                                             RenderRequest request);

    SceneAsset m_Asset;
    UniversalRenderer m_Renderer;
    VolumeManager m_Volumes;
    VolumeStack m_Stack;
    bool m_HasEnvironment = false;    ///< true if the scene has the light of its sky
    std::vector<std::string> m_Notes; ///< about what a frame could not be drawn with
};

} // namespace limn
