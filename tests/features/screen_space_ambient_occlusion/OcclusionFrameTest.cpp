#include "Mentions.h"
#include "core/scene/TestScene.h"

#include <gmock/gmock.h>
#include <limn/core/Inspector.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/ScreenSpaceAmbientOcclusion.h>

namespace limn::test
{
namespace
{

using testing::Contains;
using testing::ElementsAre;
using testing::Not;
using Settings = ScreenSpaceAmbientOcclusionSettings;

/// An empty scene; what is recorded is all there.
class AmbientOcclusionFrame : public testing::Test
{
protected:
    RenderResult Render(const Settings& settings)
    {
        UniversalRenderer renderer(Compiler());
        renderer.AddFeature(std::make_unique<ScreenSpaceAmbientOcclusion>(settings));
        RenderRequest request;
        request.scene = &m_Scene;
        request.camera = &m_Camera;
        request.width = 65;
        request.height = 31;
        request.compile.leavesOut = false;
        return m_Pipeline.RenderSingleCamera(renderer, request);
    }

    /// "texture width x height" of the first colour of each pass that has one.
    static std::vector<std::string> Targets(const RenderResult& result)
    {
        std::vector<std::string> names;
        for (const CompiledRenderPass& pass : result.frame->passes)
        {
            if (!pass.colors.empty())
            {
                const Texture& texture = *pass.colors.front().texture;
                names.push_back(texture.name() + " " + texture.DescribeSize());
            }
        }
        return names;
    }

    Scene m_Scene;
    Camera m_Camera;
    RecordingDevice m_Device;
    UniversalRenderPipeline m_Pipeline{m_Device};
};

TEST(ScreenSpaceAmbientOcclusionFeature, HasUnitysDefaultsAndNumbers)
{
    const Settings settings;
    EXPECT_EQ(settings.AOMethod, Settings::AOMethodOptions::BlueNoise);
    EXPECT_FALSE(settings.Downsample);
    EXPECT_FALSE(settings.AfterOpaque);
    EXPECT_EQ(settings.Source, Settings::DepthSource::DepthNormals);
    EXPECT_EQ(settings.NormalSamples, Settings::NormalQuality::Medium);
    EXPECT_EQ(settings.Intensity, 3.0f);
    EXPECT_EQ(settings.DirectLightingStrength, 0.25f);
    EXPECT_EQ(settings.Radius, 0.035f);
    EXPECT_EQ(settings.Samples, Settings::AOSampleOption::Medium);
    EXPECT_EQ(settings.BlurQuality, Settings::BlurQualityOptions::High);
    EXPECT_EQ(settings.Falloff, 100.0f);
    EXPECT_EQ(settings.SampleCount, -1);
    EXPECT_EQ(static_cast<int>(Settings::AOMethodOptions::InterleavedGradient), 1);
    EXPECT_EQ(static_cast<int>(Settings::DepthSource::DepthNormals), 1);
    EXPECT_EQ(static_cast<int>(Settings::NormalQuality::High), 2);
    EXPECT_EQ(static_cast<int>(Settings::AOSampleOption::Low), 2);
    EXPECT_EQ(static_cast<int>(Settings::BlurQualityOptions::Low), 2);
}

TEST(ScreenSpaceAmbientOcclusionFeature, TakesTheSampleCountOfOldFilesForSamplesOfTheirMethod)
{
    const std::pair<int, Settings::AOSampleOption> counts[] = {
        {4, Settings::AOSampleOption::Low},    {8, Settings::AOSampleOption::Low},
        {9, Settings::AOSampleOption::Medium}, {11, Settings::AOSampleOption::Medium},
        {12, Settings::AOSampleOption::High},  {20, Settings::AOSampleOption::High}};
    for (const auto& [count, samples] : counts)
    {
        ScreenSpaceAmbientOcclusion feature;
        feature.m_Settings.SampleCount = count;
        feature.Create();
        EXPECT_EQ(feature.m_Settings.Samples, samples) << count;
        EXPECT_EQ(feature.m_Settings.AOMethod, Settings::AOMethodOptions::InterleavedGradient);
        EXPECT_EQ(feature.m_Settings.SampleCount, -1);
    }
    ScreenSpaceAmbientOcclusion feature;
    feature.Create();
    EXPECT_EQ(feature.m_Settings.AOMethod, Settings::AOMethodOptions::BlueNoise);
}

TEST_F(AmbientOcclusionFrame, DrawsAndBlursBeforeOpaqueObjects)
{
    EXPECT_THAT(Targets(Render({})),
                ElementsAre("_CameraNormalsTexture 65x31", "_SSAO_OcclusionTexture0 65x31",
                            "_SSAO_OcclusionTexture1 65x31", "_SSAO_OcclusionTexture2 65x31",
                            "_ScreenSpaceOcclusionTexture 65x31", "_CameraColorAttachmentA 65x31",
                            "limn_Output 65x31"));
}

TEST_F(AmbientOcclusionFrame, DrawsHalfAsManyTexelsASideUpToTheLastBlur)
{
    Settings settings;
    settings.Source = Settings::DepthSource::Depth;
    settings.Downsample = true;
    settings.BlurQuality = Settings::BlurQualityOptions::Medium;
    EXPECT_THAT(Targets(Render(settings)),
                ElementsAre("_SSAO_OcclusionTexture0 32x15", "_SSAO_OcclusionTexture1 32x15",
                            "_ScreenSpaceOcclusionTexture 65x31", "_CameraColorAttachmentA 65x31",
                            "limn_Output 65x31"));
}

TEST_F(AmbientOcclusionFrame, BlursOnceWhereTheQualityIsLow)
{
    Settings settings;
    settings.Source = Settings::DepthSource::Depth;
    settings.BlurQuality = Settings::BlurQualityOptions::Low;
    EXPECT_THAT(Targets(Render(settings)),
                ElementsAre("_SSAO_OcclusionTexture0 65x31", "_ScreenSpaceOcclusionTexture 65x31",
                            "_CameraColorAttachmentA 65x31", "limn_Output 65x31"));
}

TEST_F(AmbientOcclusionFrame, AfterOpaqueDrawsOverThePictureAndHasNoTextureForShaders)
{
    Settings settings;
    settings.AfterOpaque = true;
    settings.Source = Settings::DepthSource::Depth;
    const RenderResult result = Render(settings);
    const std::vector<std::string> targets = Targets(result);
    EXPECT_THAT(targets, Not(Contains("_ScreenSpaceOcclusionTexture 65x31")));
    const auto opaque = std::ranges::find(targets, "_CameraColorAttachmentA 65x31");
    const auto occlusion = std::ranges::find(targets, "_SSAO_OcclusionTexture0 65x31");
    ASSERT_NE(occlusion, targets.end());
    EXPECT_LT(opaque, occlusion);
    EXPECT_TRUE(result.report.notes.empty());
}

TEST_F(AmbientOcclusionFrame, RefusesANumberThatIsNoQuality)
{
    Settings settings;
    settings.Samples = static_cast<Settings::AOSampleOption>(3);
    EXPECT_THAT([&] { Render(settings); },
                testing::ThrowsMessage<ContractError>(
                    Mentions("ScreenSpaceAmbientOcclusion.Samples", "3", "0...2")));
}

TEST_F(AmbientOcclusionFrame, HasNoPassAndAsksForNoDepthWhereASettingIsNought)
{
    const std::pair<const char*, float Settings::*> factors[] = {
        {"Intensity", &Settings::Intensity},
        {"Radius", &Settings::Radius},
        {"Falloff", &Settings::Falloff}};
    for (const auto& [name, factor] : factors)
    {
        Settings settings;
        settings.*factor = 0.0f;
        const RenderResult result = Render(settings);
        EXPECT_THAT(Targets(result),
                    ElementsAre("_CameraColorAttachmentA 65x31", "limn_Output 65x31"));
        EXPECT_THAT(result.report.notes,
                    ElementsAre(Mentions("ScreenSpaceAmbientOcclusion", "not drawn",
                                         std::string(name) + " is 0")));
    }
}

} // namespace
} // namespace limn::test
