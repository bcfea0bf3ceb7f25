#include "report/measure/StudyPicture.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
    : m_Device(device), m_Pipeline(device), m_View(std::move(asset), assets)
{
}

const RenderResult& StudyPicture::Render(Timeline* timeline)
{
    m_Request.time = time;
    m_Request.timeline = timeline;
    m_View.Render(m_Pipeline, m_Request, m_Result);
    return m_Result;
}

Image StudyPicture::Colors()
{
    constexpr const char* k_CameraColor = "_CameraColorAttachmentA";
    m_Request.compile.leavesOut = false; // a colour that goes straight into the output is 8 bits
    const HDRColorBufferPrecision usual = std::exchange( // 32 bits have few steps
        m_View.asset().hdrColorBufferPrecision, HDRColorBufferPrecision::_64Bits);
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
    m_View.asset().hdrColorBufferPrecision = usual;
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
