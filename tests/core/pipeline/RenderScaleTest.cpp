#include "pipeline/RendererHarness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ThrownMessage.h"
#include "pipeline/PipelineTest.h"
#include "renderers/DrawHarness.h"

namespace limn::test
{
namespace
{

class RenderScale : public PipelineTest<>
{
protected:
    RenderScale() : PipelineTest(65, 32)
    {
        m_Renderer.AddFeature(std::make_unique<CamerasReader>(m_Seen));
        m_Request.compile.leavesOut = false;
    }

    /// What features are told with this scale.
    const CameraData& Render(float scale)
    {
        m_Pipeline.renderScale = scale;
        m_Result = PipelineTest::Render();
        return m_Seen.back();
    }

    static glm::ivec2 TargetSize(const CameraData& data)
    {
        return {data.cameraTargetDescriptor.width, data.cameraTargetDescriptor.height};
    }

    RenderResult m_Result;
    std::vector<CameraData> m_Seen;
};

TEST_F(RenderScale, MakesTheTargetsOfAnotherSizeThanThePicture)
{
    const CameraData& data = Render(0.5f);
    EXPECT_EQ(TargetSize(data), glm::ivec2(32, 16)) << "whole texels of 32.5 x 16";
    EXPECT_EQ(data.renderScale, 0.5f);
    EXPECT_EQ(data.pixelWidth, 65);
    EXPECT_EQ(data.pixelHeight, 32);
    EXPECT_FLOAT_EQ(data.aspectRatio, 65.0f / 32.0f);
    EXPECT_EQ(data.GetProjectionMatrix(), m_Camera.projectionMatrixFor(65.0f / 32.0f));
    EXPECT_EQ(RTHandles::maxWidth(), 32) << "handles of a scale follow the target";
    EXPECT_EQ(m_Result.output.rt()->width(), 65);
    EXPECT_EQ(m_Result.output.rt()->height(), 32);
    ASSERT_FALSE(m_Result.frame->passes.empty());
    EXPECT_EQ(m_Result.frame->passes.front().colors.front().texture->width(), 32);
}

TEST_F(RenderScale, MayBeMoreThanThePicture)
{
    EXPECT_EQ(TargetSize(Render(2.0f)), glm::ivec2(130, 64));
}

// UniversalRenderPipeline.InitializeStackedCameraData's threshold (URP 14).
TEST_F(RenderScale, NearlyOneIsOne)
{
    const CameraData& data = Render(0.96f);
    EXPECT_EQ(data.renderScale, 1.0f);
    EXPECT_EQ(TargetSize(data), glm::ivec2(65, 32));
    EXPECT_NE(Render(0.94f).renderScale, 1.0f);
}

TEST_F(RenderScale, IsOfGameCamerasOnly)
{
    for (const CameraType type :
         {CameraType::SceneView, CameraType::Preview, CameraType::Reflection})
    {
        m_Camera.cameraType = type;
        EXPECT_EQ(Render(0.5f).renderScale, 1.0f) << static_cast<int>(type);
    }
}

TEST_F(RenderScale, LeavesATexelAtLeast)
{
    m_Request.width = 1;
    m_Request.height = 3;
    EXPECT_EQ(TargetSize(Render(0.1f)), glm::ivec2(1, 1));
}

TEST_F(RenderScale, OutsideItsRangeIsRefused)
{
    for (const float scale : {0.0f, 0.09f, 2.1f, std::numeric_limits<float>::quiet_NaN()})
    {
        EXPECT_THAT(ThrownMessage<ContractError>([&] { Render(scale); }),
                    testing::HasSubstr("; it must be from 0.1 to 2"));
    }
}

TEST_F(RenderScale, ScalesWhatGoesIntoATargetTextureAsWell)
{
    m_Camera.targetTexture = std::make_shared<const RenderTexture>(
        "Target", RenderTextureDescriptor(20, 10, GraphicsFormat::R8G8B8A8_UNorm), SamplerState{});
    const CameraData& data = Render(0.5f);
    EXPECT_EQ(TargetSize(data), glm::ivec2(10, 5));
    EXPECT_EQ(data.pixelWidth, 20);
    EXPECT_EQ(data.pixelHeight, 10);
}

TEST_F(RenderScale, CameraDataSayWhatFeaturesAsk)
{
    m_Camera.backgroundColor = Color(1.0f, 0.5f, 0.0f, 0.25f);
    m_Camera.transform.localPosition = {1.0f, 2.0f, 3.0f};
    m_Camera.volumeLayerMask = LayerMask(6u);
    m_Pipeline.shadows.shadowDistance = 17.0f;
    const CameraData& data = Render(1.0f);
    EXPECT_EQ(data.backgroundColor.r, 1.0f);
    EXPECT_NEAR(data.backgroundColor.g, 0.21404114, 1e-6) << "sRGB 0.5, linear (IEC 61966-2-1)";
    EXPECT_EQ(data.backgroundColor.a, 0.25f);
    EXPECT_EQ(data.worldSpaceCameraPos, glm::vec3(1, 2, 3));
    EXPECT_EQ(data.volumeLayerMask, LayerMask(6u));
    EXPECT_EQ(data.maxShadowDistance, 17.0f);
    EXPECT_TRUE(data.isDefaultViewport);
    m_Camera.farClipPlane = 9.0f;
    EXPECT_EQ(Render(1.0f).maxShadowDistance, 9.0f);
    m_Camera.nearClipPlane = 0.5f;
    m_Pipeline.shadows.shadowDistance = 0.4f;
    EXPECT_EQ(Render(1.0f).maxShadowDistance, 0.0f) << "the view begins behind them";
    m_Pipeline.shadows.shadowDistance = 4.0f;
    m_Pipeline.shadows.mainLightShadowsSupported = false;
    EXPECT_EQ(Render(1.0f).maxShadowDistance, 0.0f);
}

TEST_F(RenderScale, CameraToWorldUndoesWorldToCamera)
{
    m_Camera.transform.localPosition = {1.0f, 2.0f, 3.0f};
    // Unturned it looks along +z of the world, which is -z of its own.
    EXPECT_EQ(m_Camera.cameraToWorldMatrix() * glm::vec4(0, 0, -5, 1), glm::vec4(1, 2, 8, 1));
}

} // namespace
} // namespace limn::test
