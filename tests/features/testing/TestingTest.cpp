#include "Mentions.h"

#include <gmock/gmock.h>
#include <limn/features/AllFeatures.h>
#include <limn/testing.h>
#include <sstream>

namespace limn::test
{
namespace
{

/// A TestScene with an outline around what is in rendering layer 8 of layer 6.
class TestingHeader : public ::testing::Test
{
protected:
    TestingHeader()
    {
        ScreenSpaceOutlineSettings settings;
        settings.m_ScreenSpaceOutlineShader = m_Scene.FindShader("Hidden/ScreenSpaceOutline");
        settings.m_LayerMask = LayerMask::FromIndex(6);
        settings.m_RenderingLayerMask = 8;
        auto feature = std::make_unique<ScreenSpaceOutlineRenderFeature>(settings);
        feature->name = "Outline";
        m_Scene.renderer.AddFeature(std::move(feature));
        m_Scene.Add(ARenderer("Lamp").OnLayer(6).WithRenderingLayer(8));
        m_Scene.Add(ARenderer("Rug").OnLayer(6));
        m_Scene.Add(ARenderer("Wall").WithRenderingLayer(8));
        m_Scene.Add(ARenderer("Behind").OnLayer(6).WithRenderingLayer(8).At({0, 0, -50}));
    }

    TestScene m_Scene;
};

TEST_F(TestingHeader, SaysWhoIsDrawnByAFeatureAndWhyOthersAreNot)
{
    m_Scene.AddVolume("ScreenSpaceOutline: {m_Enable: true}");
    const TestFrame frame = m_Scene.Render();
    EXPECT_TRUE(DrawnBy(frame, "Outline", "Lamp"));
    EXPECT_EQ("Outline draws Lamp", DrawnBy(frame, "Outline", "Lamp").sentence());
    EXPECT_FALSE(DrawnBy(frame, "Outline", "Rug"));
    EXPECT_THAT(DrawnBy(frame, "Outline", "Rug").sentence(),
                Mentions("Outline", "Rug", "rendering layer mask"));
    EXPECT_THAT(DrawnBy(frame, "Outline", "Wall").sentence(),
                Mentions("Outline", "Wall", "'s layer mask"));
    EXPECT_THAT(DrawnBy(frame, "Outline", "Behind").sentence(),
                Mentions("Outline", "Behind", "not see"));
    EXPECT_TRUE(DrawnBy(frame, "Draw Opaque Objects", "Rug"));
    EXPECT_FALSE(DrawnBy(frame, "Draw Transparent Objects", "Rug"));
}

TEST_F(TestingHeader, SaysThatAFeatureIsOff)
{
    const CheckResult result = DrawnBy(m_Scene.Render(), "Outline", "Lamp");
    EXPECT_FALSE(result);
    EXPECT_THAT(result.sentence(), ::testing::HasSubstr("m_Enable"));
}

TEST_F(TestingHeader, RefusesNamesThatAreNotThere)
{
    const TestFrame frame = m_Scene.Render();
    EXPECT_THROW(DrawnBy(frame, "Outline", "Lampp"), ContractError);
    EXPECT_THROW(DrawnBy(frame, "Outlin", "Lamp"), ContractError);
    EXPECT_THROW(ARenderer("A").OnLayer(32), ContractError);
    EXPECT_THROW(ARenderer("A").WithRenderingLayer(-1), ContractError);
}

TEST(TestingFilter, IsJudgedWithoutAScene)
{
    const ARenderer lamp = ARenderer("Lamp").OnLayer(3).WithRenderingLayer(8).WithQueue(2450);
    EXPECT_TRUE(Takes(FilteringSettings(), lamp));
    EXPECT_TRUE(Takes(FilteringSettings(RenderQueueRange::opaque, LayerMask::FromIndex(3),
                                        RenderingLayerMask::FromIndex(8)),
                      lamp));
    EXPECT_THAT(Takes(FilteringSettings(std::nullopt, LayerMask::FromIndex(8)), lamp).sentence(),
                Mentions("Lamp", "'s layer mask"));
    EXPECT_THAT(Takes(FilteringSettings(RenderQueueRange::transparent), lamp).sentence(),
                Mentions("Lamp", "render queue"));
}

TEST(TestingFilter, PrintsItsSentenceInGoogleTest)
{
    const CheckResult bad(false, "Outline must draw Lamp, but it is transparent");
    EXPECT_STREQ("Outline must draw Lamp, but it is transparent",
                 ::testing::AssertionResult(bad).failure_message());
    std::ostringstream text;
    text << bad;
    EXPECT_EQ(bad.sentence(), text.str());
}

} // namespace
} // namespace limn::test
