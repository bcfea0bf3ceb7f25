#include <algorithm>
#include <gmock/gmock.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "pipeline/PipelineTest.h"
#include "pipeline/RendererHarness.h"

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

/// Draws nothing, and of formats with a stencil with few samples.
class LimitedDevice final : public GraphicsDevice
{
public:
    void Execute(const CompiledFrame& frame) override { m_Device.Execute(frame); }
    const TextureStates& textureStates() const override { return m_Device.textureStates(); }
    Image ReadBack(const RenderTexture& texture) override { return m_Device.ReadBack(texture); }
    std::vector<PassTiming> LastFrameTimings() override { return {}; }
    int GetRenderTextureSupportedMSAASampleCount(
        const RenderTextureDescriptor& descriptor) const override
    {
        return std::min(descriptor.msaaSamples, descriptor.depthBufferBits > 0 ? most : 4);
    }

    int most = 8;

private:
    RecordingDevice m_Device;
};

/// Writes down what descriptor passes are given.
class DescriptorPass final : public ScriptableRenderPass
{
public:
    void Configure(CommandBuffer&, const RenderTextureDescriptor& camera) override
    {
        seen = camera;
    }
    void Execute(ScriptableRenderContext&, RenderingData&) override {}

    RenderTextureDescriptor seen;
};

/// A cube before a camera that is drawn with four samples per texel.
class MultisampledCamera : public test::PipelineTest<LimitedDevice>
{
protected:
    MultisampledCamera() : PipelineTest(64, 32)
    {
        test::AddCube(m_Scene, "cube", {0, 0, 10},
                      {std::make_shared<Material>(test::ShaderWithProgram("", "", "1"))});
        m_Pipeline.msaaSampleCount = 4;
    }

    int Samples() { return Render().frame->passes.at(0).depth->texture->descriptor().msaaSamples; }
};

TEST_F(MultisampledCamera, IsDrawnInSamplesThatAreResolvedForTheOutputAndNotKept)
{
    const RenderResult result = Render();
    ASSERT_EQ(result.frame->passes.size(), 2u);
    const auto& color = result.frame->passes[0].colors.at(0);
    EXPECT_EQ(color.texture->descriptor().msaaSamples, 4);
    EXPECT_EQ(color.resolve, color.texture);
    EXPECT_EQ(color.store, StoreOp::DontCare);
    const DepthAttachment& depth = result.frame->passes[0].depth.value();
    EXPECT_EQ(depth.texture->descriptor().msaaSamples, 4);
    EXPECT_EQ(depth.resolve, nullptr);
    EXPECT_EQ(result.output.rt()->descriptor().msaaSamples, 1);
    EXPECT_THAT(result.report.notes, IsEmpty());
}

TEST_F(MultisampledCamera, TellsPassesItsSamples)
{
    DescriptorPass pass;
    test::Log log;
    m_Renderer.AddFeature(std::make_unique<test::LoggingFeature>(
        "feature", log, std::vector<ScriptableRenderPass*>{&pass}));
    Render();
    EXPECT_EQ(pass.seen.msaaSamples, 4);
    EXPECT_EQ(pass.seen.depthBufferBits, 32);
}

TEST_F(MultisampledCamera, HasOneSampleIfTheCameraAllowsNoMore)
{
    m_Camera.allowMSAA = false;
    EXPECT_EQ(Samples(), 1);
    m_Camera.allowMSAA = true;
    EXPECT_EQ(Samples(), 4);
}

// URP: CameraData's samples are the target texture's where the camera allows them and the
// pipeline has more than one.
TEST_F(MultisampledCamera, HasTheSamplesOfItsTargetTextureIfCameraAndPipelineLetIt)
{
    RenderTextureDescriptor descriptor(64, 32, GraphicsFormat::R8G8B8A8_UNorm);
    descriptor.msaaSamples = 2;
    m_Camera.targetTexture = std::make_shared<const RenderTexture>("target", descriptor);
    EXPECT_EQ(Samples(), 2);
    m_Camera.allowMSAA = false;
    EXPECT_EQ(Samples(), 1);
    m_Camera.allowMSAA = true;
    m_Pipeline.msaaSampleCount = 1;
    EXPECT_EQ(Samples(), 1);
}

TEST_F(MultisampledCamera, HasTheSamplesThatTheDeviceDoesOfColorAndDepth)
{
    m_Device.most = 2;
    EXPECT_EQ(Samples(), 2);
    EXPECT_THAT(Render().report.notes,
                ElementsAre(test::Mentions("2 samples", "4", "msaaSampleCount", "device")));
    m_Device.most = 8;
    m_Pipeline.msaaSampleCount = 8;
    EXPECT_EQ(Samples(), 4);
}

TEST_F(MultisampledCamera, HasNoSamplesAndNoCopyWhereNothingIsDrawn)
{
    m_Scene = Scene();
    m_Camera.backgroundColor = {49.0f / 255.0f, 77.0f / 255.0f, 121.0f / 255.0f};
    const RenderResult result = Render();
    ASSERT_EQ(result.frame->passes.size(), 1u);
    EXPECT_EQ(result.frame->passes[0].colors.at(0).texture, result.output.rt());
    EXPECT_EQ(result.frame->passes[0].colors.at(0).load, LoadOp::Clear);
    EXPECT_FALSE(result.frame->passes[0].depth);
    EXPECT_THAT(result.frame->placed, IsEmpty());
}

// 76.5 / 255: the device decides which step the output shows, so that the copy has to stay.
TEST_F(MultisampledCamera, HasNoSamplesWhereNothingIsDrawnBeforeABackgroundBetweenTwoSteps)
{
    m_Scene = Scene();
    m_Camera.backgroundColor = {0.3f, 0.3f, 0.3f};
    const RenderResult result = Render();
    ASSERT_EQ(result.frame->passes.size(), 2u);
    const auto& color = result.frame->passes[0].colors.at(0);
    EXPECT_EQ(color.load, LoadOp::Clear);
    EXPECT_EQ(color.resolve, nullptr);
    EXPECT_EQ(color.texture->descriptor().msaaSamples, 1);
    EXPECT_EQ(color.texture->graphicsFormat(), GraphicsFormat::R16G16B16A16_SFloat);
    EXPECT_EQ(result.frame->passes[1].colors.at(0).texture, result.output.rt());
    EXPECT_EQ(result.frame->passes[1].barriers.at(0).texture, color.texture);
}

TEST_F(MultisampledCamera, RefusesOtherNumbersOfSamples)
{
    m_Pipeline.msaaSampleCount = 3;
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Render(); }),
                test::Mentions("UniversalRenderPipeline", "msaaSampleCount", "3", "1, 2, 4 or 8"));
}

TEST_F(MultisampledCamera, IsClearedToBlackWhereItClearsNothing)
{
    m_Camera.clearFlags = CameraClearFlags::Nothing;
    m_Camera.backgroundColor = Color::green;
    const auto color = Render().frame->passes.at(0).colors.at(0);
    EXPECT_EQ(color.load, LoadOp::Clear);
    EXPECT_EQ(color.clearColor, Color::black);
}

} // namespace
} // namespace limn
