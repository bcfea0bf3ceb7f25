#include "pipeline/RendererHarness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Mentions.h"
#include "pipeline/PipelineTest.h"

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

/// A device that does not do one thing with colours of 32 bits that are HDR.
class DeviceWithout final : public GraphicsDevice
{
public:
    explicit DeviceWithout(FormatUsage missing) : m_Missing(missing) {}

    void Execute(const CompiledFrame& frame) override { m_Device.Execute(frame); }
    const TextureStates& textureStates() const override { return m_Device.textureStates(); }
    Image ReadBack(const RenderTexture& texture) override { return m_Device.ReadBack(texture); }
    std::vector<PassTiming> LastFrameTimings() override { return {}; }
    int GetRenderTextureSupportedMSAASampleCount(
        const RenderTextureDescriptor& descriptor) const override
    {
        return descriptor.msaaSamples;
    }
    bool IsFormatSupported(GraphicsFormat format, FormatUsage usage) const override
    {
        return format != GraphicsFormat::B10G11R11_UFloatPack32 || usage != m_Missing;
    }

private:
    FormatUsage m_Missing;
    RecordingDevice m_Device;
};

class HdrPrecision : public PipelineTest<>
{
protected:
    HdrPrecision() : PipelineTest(16, 8)
    {
        m_Renderer.AddFeature(std::make_unique<CamerasReader>(m_Seen));
        m_Pipeline.hdrColorBufferPrecision = HDRColorBufferPrecision::_32Bits;
    }

    /// Returns the format of the colour that features are told.
    GraphicsFormat FormatOf(UniversalRenderPipeline& pipeline)
    {
        m_Notes = pipeline.RenderSingleCamera(m_Renderer, m_Request).report.notes;
        return m_Seen.back().cameraTargetDescriptor.graphicsFormat;
    }
    GraphicsFormat Format() { return FormatOf(m_Pipeline); }

    std::vector<CameraData> m_Seen;
    std::vector<std::string> m_Notes;
};

TEST_F(HdrPrecision, Is64BitsUnlessItIsSet)
{
    EXPECT_EQ(Format(), GraphicsFormat::B10G11R11_UFloatPack32);
    EXPECT_THAT(m_Notes, IsEmpty());
    m_Pipeline.hdrColorBufferPrecision = HDRColorBufferPrecision::_64Bits;
    EXPECT_EQ(Format(), GraphicsFormat::R16G16B16A16_SFloat);
    UniversalRenderPipeline other(m_Device);
    EXPECT_EQ(FormatOf(other), GraphicsFormat::R16G16B16A16_SFloat);
}

TEST_F(HdrPrecision, IsOfNoCameraWithoutHdrAndOfNoTargetTexture)
{
    m_Camera.allowHDR = false;
    EXPECT_EQ(Format(), GraphicsFormat::R8G8B8A8_SRGB);
    EXPECT_FALSE(m_Seen.back().isHdrEnabled);
    m_Camera.allowHDR = true;
    m_Pipeline.supportsHDR = false;
    EXPECT_EQ(Format(), GraphicsFormat::R8G8B8A8_SRGB);
    EXPECT_FALSE(m_Seen.back().isHdrEnabled);
    m_Pipeline.supportsHDR = true;
    m_Camera.targetTexture = std::make_shared<const RenderTexture>(
        "target", RenderTextureDescriptor(16, 8, GraphicsFormat::R16G16B16A16_SFloat));
    EXPECT_EQ(Format(), GraphicsFormat::R16G16B16A16_SFloat);
    EXPECT_TRUE(m_Seen.back().isHdrEnabled);
}

TEST_F(HdrPrecision, Is64BitsWithANoteWhereTheDeviceCannotDrawOrBlend32)
{
    for (const FormatUsage missing : {FormatUsage::Render, FormatUsage::Blend})
    {
        DeviceWithout device(missing);
        UniversalRenderPipeline pipeline(device);
        pipeline.hdrColorBufferPrecision = HDRColorBufferPrecision::_32Bits;
        EXPECT_EQ(FormatOf(pipeline), GraphicsFormat::R16G16B16A16_SFloat);
        EXPECT_THAT(m_Notes, ElementsAre(Mentions("64 bits", "32", "hdrColorBufferPrecision",
                                                  "device", "B10G11R11_UFloatPack32")));
        m_Camera.allowHDR = false;
        FormatOf(pipeline);
        EXPECT_THAT(m_Notes, IsEmpty()) << "an LDR camera asks for none";
        m_Camera.allowHDR = true;
    }
}

} // namespace
} // namespace limn::test
