#pragma once

#include "report/truth/OutlineReference.h"
#include "scene/SceneView.h"

namespace limn::study
{

/// Draws a scene again and again, and returns its pictures as numbers.
class StudyPicture
{
public:
    /// @param asset   the scene after UseTechnique; its features are created here
    /// @param assets, device  must outlive this
    StudyPicture(SceneAsset asset, const AssetContext& assets, GraphicsDevice& device);

    SceneAsset& asset() { return m_View.asset(); } ///< without its features
    double time = 0.0;                             ///< in seconds, the _Time of the next frame

    /// Draws a frame.
    /// @param timeline  receives the times of the phases; may be null
    const RenderResult& Render(Timeline* timeline = nullptr);
    /// Draws a frame and returns the camera's colour before it is rounded to 8 bits:
    /// R16G16B16A16_SFloat if the camera allows HDR.
    Image Colors();
    /// Draws a frame and returns the first channel of Colors(), linear.
    Coverage Alpha();
    /// Draws a frame and returns what a person sees, in R8G8B8A8_SRGB.
    Image Output();

private:
    GraphicsDevice& m_Device;
    UniversalRenderPipeline m_Pipeline;
    SceneView m_View;
    RenderRequest m_Request;
    RenderResult m_Result;
};

} // namespace limn::study
