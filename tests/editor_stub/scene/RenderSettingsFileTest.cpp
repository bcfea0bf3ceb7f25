#include "Mentions.h"
#include "SceneFolder.h"

#include <gmock/gmock.h>
#include <limn/core/Material.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* k_Sky = "skybox: day\nmaterials: {day: {shader: Skybox/Procedural}}\n";

TEST(RenderSettingsFile, HasUnitysNames)
{
    SceneFolder folder;
    const SceneAsset asset = folder.LoadWithCamera("ambientLight: [0.5, 0.25, 0]\n"
                                                   "renderSettings:\n"
                                                   "  ambientMode: Trilight\n"
                                                   "  ambientEquatorColor: [0, 0.5, 0.25]\n"
                                                   "  ambientGroundColor: [0.25, 0, 0.5]\n"
                                                   "  ambientIntensity: 2\n"
                                                   "  fog: true\n"
                                                   "  fogMode: Linear\n"
                                                   "  fogColor: [0.125, 0.5, 0.75]\n"
                                                   "  fogDensity: 0.5\n"
                                                   "  fogStartDistance: 3\n"
                                                   "  fogEndDistance: 12\n"
                                                   "  reflectionIntensity: 0.5\n");
    const Scene& scene = asset.scene;
    EXPECT_EQ(AmbientMode::Trilight, scene.ambientMode);
    EXPECT_EQ((Color{0.5f, 0.25f, 0.0f, 1.0f}), scene.ambientSkyColor);
    EXPECT_EQ((Color{0.0f, 0.5f, 0.25f, 1.0f}), scene.ambientEquatorColor);
    EXPECT_EQ((Color{0.25f, 0.0f, 0.5f, 1.0f}), scene.ambientGroundColor);
    EXPECT_EQ(2.0f, scene.ambientIntensity);
    EXPECT_TRUE(scene.fog);
    EXPECT_EQ(FogMode::Linear, scene.fogMode);
    EXPECT_EQ((Color{0.125f, 0.5f, 0.75f, 1.0f}), scene.fogColor);
    EXPECT_EQ(0.5f, scene.fogDensity);
    EXPECT_EQ(3.0f, scene.fogStartDistance);
    EXPECT_EQ(12.0f, scene.fogEndDistance);
    EXPECT_EQ(0.5f, scene.reflectionIntensity);
    EXPECT_EQ(DefaultReflectionMode::Custom, scene.defaultReflectionMode);
}

TEST(RenderSettingsFile, MayLightByTheSky)
{
    SceneFolder folder;
    const SceneAsset asset = folder.LoadWithCamera(
        "ambientLight: [1, 1, 0]\n"
        "renderSettings: {ambientMode: Skybox, defaultReflectionMode: Skybox,\n"
        "                 defaultReflectionResolution: 64}\n" +
        std::string(k_Sky));
    EXPECT_EQ(AmbientMode::Skybox, asset.scene.ambientMode);
    EXPECT_EQ(DefaultReflectionMode::Skybox, asset.scene.defaultReflectionMode);
    EXPECT_EQ(64, asset.scene.defaultReflectionResolution);
    EXPECT_EQ(glm::vec3(1, 1, 0), asset.scene.AmbientLight().Evaluate({0, 1, 0}))
        << "until the sky is drawn";
}

TEST(RenderSettingsFile, NeedsASkyThatItIsLitBy)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("camera: {}\nrenderSettings: {ambientMode: Skybox}\n"),
                ElementsAre(Mentions("renderSettings.ambientMode: Skybox", "no sky")));
    EXPECT_THAT(folder.ProblemsOf("camera: {}\nrenderSettings: {defaultReflectionMode: Skybox}\n"),
                ElementsAre(HasSubstr("renderSettings.defaultReflectionMode: Skybox, but")));
}

TEST(RenderSettingsFile, RefusesWhatIsOutOfRange)
{
    SceneFolder folder;
    EXPECT_THAT(
        folder.ProblemsOf("camera: {}\n"
                          "renderSettings:\n"
                          "  fogMode: Thick\n"
                          "  fogDensity: -1\n"
                          "  fogEndDistance: 1e12\n"
                          "  ambientIntensity: 9\n"
                          "  defaultReflectionResolution: 100\n"
                          "  fogColour: [1, 1, 1]\n"),
        ElementsAre(
            HasSubstr("3:12: renderSettings.fogMode: unknown value 'Thick'"),
            HasSubstr("4:15: renderSettings.fogDensity: -1"),
            HasSubstr("5:19: renderSettings.fogEndDistance: 1e12"),
            HasSubstr("6:21: renderSettings.ambientIntensity: 9"),
            Mentions("7:32: renderSettings.defaultReflectionResolution:", "100", "power of two"),
            Mentions("8:3: renderSettings:", "unknown key", "'fogColour'", "'fogColor'")));
}

} // namespace
} // namespace limn::test
