#pragma once

#include "report/truth/OutlineReference.h"
#include "view/SceneView.h"

namespace limn::study
{

/// A scene that is drawn again and again, and what it shows as numbers.
class StudyPicture
{
public:
    /// @param asset   as UseTechnique left it; its features are created here
    /// @param assets, device  must outlive this
    StudyPicture(SceneAsset asset, const AssetContext& assets, GraphicsDevice& device);

    SceneAsset& asset() { return m_View.asset(); } ///< without its features
    double time = 0.0;                             ///< seconds, what the next frame's _Time shows

    /// @param timeline  gets how long the phases take; may be null
    const RenderResult& Render(Timeline* timeline = nullptr);
    /// The camera's colour of a new frame before it is rounded to 8 bits: R16G16B16A16_SFloat where
    /// the camera allows HDR.
    Image Colors();
    /// The first channel of Colors(), linear.
    Coverage Alpha();
    /// What a person sees, R8G8B8A8_SRGB, of a new frame.
    Image Output();

private:
    GraphicsDevice& m_Device;
    UniversalRenderPipeline m_Pipeline;
    SceneView m_View;
    RenderRequest m_Request;
    RenderResult m_Result;
};

} // namespace limn::study
