#include "SceneFolder.h"

#include <gmock/gmock.h>
#include <limn/features/ScreenSpaceAmbientOcclusion.h>

namespace limn::test
{
namespace
{

using OcclusionSettings = ScreenSpaceAmbientOcclusionSettings;

std::string WithOcclusion(const std::string& settings)
{
    return "renderer: {features: [{type: ScreenSpaceAmbientOcclusion" + settings + "}]}\n";
}

const OcclusionSettings& OcclusionIn(const SceneAsset& asset)
{
    return dynamic_cast<const ScreenSpaceAmbientOcclusion&>(*asset.renderer.features.at(0))
        .m_Settings;
}

TEST(AmbientOcclusionInAScene, TakesEverySettingUnderUnitysName)
{
    SceneFolder folder;
    const SceneAsset asset = folder.LoadWithCamera(WithOcclusion(
        ", name: SSAO, AOMethod: InterleavedGradient, Downsample: true, AfterOpaque: true, Source: "
        "Depth, NormalSamples: High, Intensity: 1.5, DirectLightingStrength: 1, Radius: 0.2, "
        "Samples: Low, BlurQuality: Medium, Falloff: 20"));
    const OcclusionSettings& settings = OcclusionIn(asset);
    EXPECT_EQ("SSAO", asset.renderer.features[0]->name);
    EXPECT_EQ(OcclusionSettings::AOMethodOptions::InterleavedGradient, settings.AOMethod);
    EXPECT_TRUE(settings.Downsample);
    EXPECT_TRUE(settings.AfterOpaque);
    EXPECT_EQ(OcclusionSettings::DepthSource::Depth, settings.Source);
    EXPECT_EQ(OcclusionSettings::NormalQuality::High, settings.NormalSamples);
    EXPECT_EQ(1.5f, settings.Intensity);
    EXPECT_EQ(1.0f, settings.DirectLightingStrength);
    EXPECT_EQ(0.2f, settings.Radius);
    EXPECT_EQ(OcclusionSettings::AOSampleOption::Low, settings.Samples);
    EXPECT_EQ(OcclusionSettings::BlurQualityOptions::Medium, settings.BlurQuality);
    EXPECT_EQ(20.0f, settings.Falloff);
}

TEST(AmbientOcclusionInAScene, RefusesNumbersOutsideOfTheirRangesAndUnknownNames)
{
    SceneFolder folder;
    for (const char* wrong : {"Intensity: -1", "Radius: -0.1", "DirectLightingStrength: 1.5",
                              "Falloff: -5", "Samples: Ultra", "Intensty: 1"})
    {
        EXPECT_THROW(folder.LoadWithCamera(WithOcclusion(std::string(", ") + wrong)), AssetError)
            << wrong;
    }
}

} // namespace
} // namespace limn::test
