#pragma once

#include "report/truth/OutlineReference.h"

#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/VolumeManager.h>

namespace limn::study
{

/// A scene that is drawn again and again, and what it shows as numbers.
class StudyPicture
{
public:
    /// @param asset   as UseTechnique left it; its features are created here
    /// @param assets, device  must outlive this
    StudyPicture(SceneAsset asset, const AssetContext& assets, GraphicsDevice& device);

    Scene& scene() { return m_Asset.scene; }
    Camera& camera() { return m_Asset.camera; }
    int width() const { return m_Asset.width; }
    int height() const { return m_Asset.height; }
    /// For what is the pipeline's: samples and the like.
    UniversalRenderPipeline& pipeline() { return m_Pipeline; }
    double time = 0.0; ///< seconds, what the next frame's _Time shows

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
    SceneAsset m_Asset;
    GraphicsDevice& m_Device;
    UniversalRenderPipeline m_Pipeline;
    UniversalRenderer m_Renderer;
    VolumeManager m_Volumes;
    VolumeStack m_Stack;
    RenderRequest m_Request;
    RenderResult m_Result;
};

} // namespace limn::study
