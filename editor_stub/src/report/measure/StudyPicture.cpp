#include "report/measure/StudyPicture.h"

#include <algorithm>
#include <cmath>

namespace limn::study
{

namespace
{

double FromSrgb(double value)
{
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

} // namespace

StudyPicture::StudyPicture(SceneAsset asset, const AssetContext& assets, GraphicsDevice& device)
    : m_Asset(std::move(asset)),
      m_Device(device),
      m_Pipeline(device),
      m_Renderer(assets.compiler()),
      m_Volumes(assets.volumeComponents()),
      m_Stack(m_Volumes.CreateStack())
{
    m_Renderer.SetShaderSource(assets.shaderSource());
    m_Renderer.opaqueLayerMask = m_Asset.renderer.opaqueLayerMask;
    m_Renderer.transparentLayerMask = m_Asset.renderer.transparentLayerMask;
    for (std::unique_ptr<ScriptableRendererFeature>& feature : m_Asset.renderer.features)
    {
        m_Renderer.AddFeature(std::move(feature));
    }
    m_Asset.renderer.features.clear();
    for (const Volume& volume : m_Asset.volumes)
    {
        m_Volumes.Register(&volume);
    }
    m_Pipeline.msaaSampleCount = m_Asset.msaaSampleCount;
    m_Pipeline.supportsHDR = m_Asset.supportsHDR;
    m_Pipeline.hdrColorBufferPrecision = m_Asset.hdrColorBufferPrecision;
    m_Pipeline.renderScale = m_Asset.renderScale;
    m_Pipeline.maxAdditionalLightsCount = m_Asset.maxAdditionalLightsCount;
    m_Pipeline.pipelineVersion = m_Asset.pipelineVersion;
    m_Pipeline.shadows = m_Asset.shadows;
}

const RenderResult& StudyPicture::Render(Timeline* timeline)
{
    const Camera& camera = m_Asset.camera;
    m_Volumes.Update(m_Stack, camera.volumeTrigger.value_or(camera.transform.position()),
                     camera.volumeLayerMask);
    m_Request.scene = &m_Asset.scene;
    m_Request.camera = &camera;
    m_Request.width = m_Asset.width;
    m_Request.height = m_Asset.height;
    m_Request.time = time;
    m_Request.volumeStack = &m_Stack;
    m_Request.timeline = timeline;
    m_Pipeline.RenderSingleCamera(m_Renderer, m_Request, m_Result);
    return m_Result;
}

Image StudyPicture::Colors()
{
    constexpr const char* k_CameraColor = "_CameraColorAttachmentA";
    m_Request.compile.leavesOut = false; // a colour that goes straight into the output is 8 bits
    m_Pipeline.hdrColorBufferPrecision = HDRColorBufferPrecision::_64Bits; // 32 bits have few steps
    m_Request.alsoReadBack.clear();
    Render();
    for (const CompiledRenderPass& pass : m_Result.frame->passes)
    {
        if (!pass.colors.empty() && pass.colors.front().texture->name() == k_CameraColor)
        {
            m_Request.alsoReadBack = {RTHandle(pass.colors.front().texture)};
        }
    }
    Render();
    m_Request.compile.leavesOut = true;
    m_Pipeline.hdrColorBufferPrecision = m_Asset.hdrColorBufferPrecision;
    return m_Device.ReadBack(*m_Request.alsoReadBack.at(0).rt());
}

Coverage StudyPicture::Alpha()
{
    const Image colors = Colors();
    Coverage alpha = ChannelOf(colors, 0);
    if (IsSRGBFormat(colors.format)) // of a camera without HDR
    {
        std::ranges::transform(alpha.values, alpha.values.begin(), FromSrgb);
    }
    return alpha;
}

Image StudyPicture::Output()
{
    m_Request.alsoReadBack.clear();
    Render();
    return m_Device.ReadBack(*m_Result.output.rt());
}

} // namespace limn::study
