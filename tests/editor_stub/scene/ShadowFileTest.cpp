#include "Mentions.h"
#include "SceneFolder.h"

#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

TEST(ShadowFile, TheLightSaysHowItsShadowsAre)
{
    SceneFolder folder;
    const DirectionalLight light = folder
                                       .LoadWithCamera("light: {shadows: Soft, shadowStrength: "
                                                       "0.5, softShadowQuality: High,\n"
                                                       "  usePipelineSettings: false, "
                                                       "shadowBias: 2, shadowNormalBias: 3}\n")
                                       .scene.mainLight;
    EXPECT_EQ(LightShadows::Soft, light.shadows);
    EXPECT_EQ(0.5f, light.shadowStrength);
    EXPECT_EQ(SoftShadowQuality::High, light.softShadowQuality);
    EXPECT_FALSE(light.usePipelineSettings);
    EXPECT_EQ(2.0f, light.shadowBias);
    EXPECT_EQ(3.0f, light.shadowNormalBias);
    EXPECT_EQ(LightShadows::None, folder.LoadWithCamera("").scene.mainLight.shadows);
    EXPECT_THAT(folder.ProblemsOf("camera: {}\n"
                                  "light: {shadows: Smooth, shadowStrength: 2}\n"),
                testing::SizeIs(2));
}

TEST(ShadowFile, OtherLightsSayHowTheirShadowsAre)
{
    SceneFolder folder;
    const SceneAsset asset = folder.LoadWithCamera(
        "lights:\n"
        "  - {shadows: Hard, shadowStrength: 0.25, shadowNearPlane: 0.5}\n"
        "  - {type: Spot, shadows: Soft, softShadowQuality: Low, usePipelineSettings: false,\n"
        "     shadowBias: 2, shadowNormalBias: 3, shadowResolution: 64,\n"
        "     additionalLightsShadowResolutionTier: Custom}\n"
        "  - {}\n"
        "shadows: {additionalLightShadowsSupported: false}\n");
    EXPECT_FALSE(asset.shadows.additionalLightShadowsSupported);
    const std::vector<Light>& lights = asset.scene.additionalLights;
    ASSERT_EQ(3u, lights.size());
    EXPECT_EQ(LightShadows::Hard, lights[0].shadows);
    EXPECT_EQ(0.25f, lights[0].shadowStrength);
    EXPECT_EQ(0.5f, lights[0].shadowNearPlane);
    EXPECT_EQ(LightShadows::Soft, lights[1].shadows);
    EXPECT_EQ(SoftShadowQuality::Low, lights[1].softShadowQuality);
    EXPECT_FALSE(lights[1].usePipelineSettings);
    EXPECT_EQ(2.0f, lights[1].shadowBias);
    EXPECT_EQ(3.0f, lights[1].shadowNormalBias);
    EXPECT_EQ(AdditionalLightsShadowResolutionTier::Custom,
              lights[1].additionalLightsShadowResolutionTier);
    EXPECT_EQ(64, lights[1].shadowResolution);
    EXPECT_EQ(AdditionalLightsShadowResolutionTier::High,
              lights[2].additionalLightsShadowResolutionTier);
    EXPECT_EQ(LightShadows::None, lights[2].shadows);
    EXPECT_THAT(
        folder.ProblemsOf("camera: {}\nlights:\n  - {shadows: Smooth, shadowNearPlane: 0}\n"),
        testing::SizeIs(2));
}

TEST(ShadowFile, TheSceneSaysHowAllShadowsAreInEitherSpelling)
{
    SceneFolder folder;
    const ShadowSettings settings = folder
                                        .LoadWithCamera("shadows:\n"
                                                        "  shadowDistance: 20\n"
                                                        "  m_ShadowCascadeCount: 3\n"
                                                        "  cascade3Split: [0.2, 0.5]\n"
                                                        "  softShadowQuality: Low\n"
                                                        "  mainLightShadowmapResolution: 512\n")
                                        .shadows;
    ShadowSettings wanted;
    wanted.shadowDistance = 20.0f;
    wanted.shadowCascadeCount = 3;
    wanted.cascade3Split = {0.2f, 0.5f};
    wanted.softShadowQuality = SoftShadowQuality::Low;
    wanted.mainLightShadowmapResolution = 512;
    EXPECT_EQ(wanted, settings);
    EXPECT_THAT(folder.ProblemsOf("camera: {}\n"
                                  "shadows: {shadowCascadeCount: 5, distance: 3}\n"),
                testing::ElementsAre(testing::HasSubstr("shadows.m_ShadowCascadeCount: 5"),
                                     testing::HasSubstr("unknown key 'distance'")));
    EXPECT_THAT(folder.ProblemsOf("camera: {}\n"
                                  "shadows: {shadowCascadeCount: 4, cascade2Split: 1, "
                                  "cascade4Split: [0.5, 0.4, 0.9]}\n"),
                testing::ElementsAre(Mentions("m_Cascade4Split", "shares", "0 and 1")));
}

TEST(ShadowFile, TheyComeFromUnitysPipelineAsset)
{
    SceneFolder folder;
    folder.Write("urp.asset", "%YAML 1.1\n"
                              "%TAG !u! tag:unity3d.com,2011:\n"
                              "--- !u!114 &11400000\n"
                              "MonoBehaviour:\n"
                              "  m_Name: URP-HighFidelity\n"
                              "  m_MSAA: 4\n"
                              "  m_MainLightShadowsSupported: 1\n"
                              "  m_MainLightShadowmapResolution: 4096\n"
                              "  m_AdditionalLightsShadowmapResolution: 1024\n"
                              "  m_AdditionalLightsShadowResolutionTierLow: 128\n"
                              "  m_AdditionalLightsShadowResolutionTierMedium: 256\n"
                              "  m_AdditionalLightsShadowResolutionTierHigh: 512\n"
                              "  m_ShadowDistance: 150\n"
                              "  m_ShadowCascadeCount: 4\n"
                              "  m_Cascade2Split: 0.25\n"
                              "  m_Cascade3Split: {x: 0.1, y: 0.3}\n"
                              "  m_Cascade4Split: {x: 0.067, y: 0.2, z: 0.467}\n"
                              "  m_CascadeBorder: 0.1\n"
                              "  m_ShadowDepthBias: 1\n"
                              "  m_ShadowNormalBias: 0.5\n"
                              "  m_SoftShadowsSupported: 1\n"
                              "  m_SoftShadowQuality: 3\n");
    ShadowSettings wanted;
    wanted.mainLightShadowmapResolution = 4096;
    wanted.additionalLightShadowsSupported = false; // Unity's default
    wanted.additionalLightsShadowmapResolution = 1024;
    wanted.additionalLightsShadowResolutionTierLow = 128;
    wanted.additionalLightsShadowResolutionTierMedium = 256;
    wanted.additionalLightsShadowResolutionTierHigh = 512;
    wanted.shadowDistance = 150.0f;
    wanted.shadowCascadeCount = 4;
    wanted.cascadeBorder = 0.1f;
    wanted.shadowNormalBias = 0.5f;
    wanted.softShadowQuality = SoftShadowQuality::High;
    const SceneAsset asset = folder.LoadWithCamera("renderPipelineAsset: urp.asset\n");
    EXPECT_EQ(wanted, asset.shadows);
    EXPECT_EQ(4, asset.msaaSampleCount);
    EXPECT_THAT(folder.ProblemsOf("camera:\nshadows: {}\nrenderPipelineAsset: urp.asset\n"),
                testing::ElementsAre(Mentions("2:10: shadows:", "renderPipelineAsset", "already")));
}

TEST(ShadowFile, AnObjectSaysWhetherItThrowsOneAndItsChildrenFollow)
{
    SceneFolder folder;
    SceneAsset asset =
        folder.LoadWithCamera("objects:\n"
                              "  - {name: A, mesh: cube}\n"
                              "  - name: B\n"
                              "    shadowCastingMode: ShadowsOnly\n"
                              "    children:\n"
                              "      - {name: C, mesh: cube}\n"
                              "      - {name: D, mesh: cube, shadowCastingMode: TwoSided}\n");
    const auto modeOf = [&](const char* name)
    {
        return asset.scene.Find(name)->renderer->shadowCastingMode;
    };
    EXPECT_EQ(ShadowCastingMode::On, modeOf("A"));
    EXPECT_EQ(ShadowCastingMode::ShadowsOnly, modeOf("C"));
    EXPECT_EQ(ShadowCastingMode::TwoSided, modeOf("D"));
}

} // namespace
} // namespace limn::test
