#include <gtest/gtest.h>
#include <limn/core/Scene.h>
#include <limn/core/Texture.h>

namespace limn::test
{
namespace
{

void ExpectColor(const Color& wanted, const glm::vec3& seen)
{
    const Color linear = wanted.linear();
    EXPECT_NEAR(linear.r, seen.r, 1e-6f);
    EXPECT_NEAR(linear.g, seen.g, 1e-6f);
    EXPECT_NEAR(linear.b, seen.b, 1e-6f);
}

const glm::vec3 k_Directions[] = {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, {0.6f, 0, 0.8f}};

TEST(RenderSettings, HaveTheSameLightFromAllSidesAndNothingElseToBeginWith)
{
    const Scene scene;
    EXPECT_EQ((Color{0.2f, 0.2f, 0.2f, 1.0f}), scene.ambientLight);
    EXPECT_FALSE(scene.fog);
    EXPECT_EQ(nullptr, scene.ReflectionTexture());
    for (const glm::vec3& direction : k_Directions)
    {
        ExpectColor(scene.ambientLight, scene.AmbientLight().Evaluate(direction));
    }
}

TEST(RenderSettings, HaveOneColorByTheNamesAmbientLightAndAmbientSkyColor)
{
    Scene scene;
    scene.ambientSkyColor = Color::red;
    EXPECT_EQ(Color::red, scene.ambientLight);
    scene.ambientLight = Color::blue;
    const Scene moved = std::move(scene);
    EXPECT_EQ(Color::blue, moved.ambientSkyColor);
}

TEST(RenderSettings, LightByHeightInModeTrilight)
{
    RenderSettings settings;
    settings.ambientMode = AmbientMode::Trilight;
    settings.ambientSkyColor = {0.9f, 0.1f, 0.4f};
    settings.ambientEquatorColor = {0.2f, 0.7f, 0.1f};
    settings.ambientGroundColor = {0.05f, 0.3f, 0.8f};
    const SphericalHarmonicsL2 light = settings.AmbientLight();
    ExpectColor(settings.ambientSkyColor, light.Evaluate({0, 1, 0}));
    ExpectColor(settings.ambientGroundColor, light.Evaluate({0, -1, 0}));
    for (const glm::vec3& side :
         {glm::vec3(1, 0, 0), glm::vec3(0, 0, -1), glm::vec3(0.6f, 0, 0.8f)})
    {
        ExpectColor(settings.ambientEquatorColor, light.Evaluate(side));
    }
    // The same around the vertical between, on the parabola through the three.
    const glm::vec3 oneWay = light.Evaluate({0.8f, 0.6f, 0});
    const glm::vec3 another = light.Evaluate({0, 0.6f, -0.8f});
    EXPECT_NEAR(oneWay.r, another.r, 1e-6f);
    const float up = settings.ambientSkyColor.linear().r;
    const float side = settings.ambientEquatorColor.linear().r;
    const float down = settings.ambientGroundColor.linear().r;
    EXPECT_NEAR(side * (1.0f - 0.36f) + up * 0.3f * 1.6f - down * 0.3f * 0.4f, oneWay.r, 1e-6f);
}

TEST(RenderSettings, MultiplyTheProbeByTheIntensityInModeSkyboxOnly)
{
    RenderSettings settings;
    settings.ambientProbe.AddAmbientLight({0.25f, 0.5f, 0.75f});
    settings.ambientProbe(1, 2) = 0.125f;
    settings.ambientIntensity = 2.0f;
    settings.ambientMode = AmbientMode::Custom;
    EXPECT_EQ(settings.ambientProbe, settings.AmbientLight());
    settings.ambientMode = AmbientMode::Skybox;
    EXPECT_EQ(glm::vec3(0.5f, 1.25f, 1.5f), settings.AmbientLight().Evaluate({0, 0, 1}));
}

TEST(RenderSettings, MirrorTheTextureOfTheMode)
{
    RenderSettings settings;
    const auto cube = [](const char* name)
    {
        CubemapFaces faces;
        faces.fill(std::vector<std::byte>(4));
        return std::make_shared<const Cubemap>(name, 1, GraphicsFormat::R8G8B8A8_UNorm,
                                               std::move(faces));
    };
    settings.customReflectionTexture = cube("custom");
    settings.skyReflection = cube("sky");
    EXPECT_EQ(settings.customReflectionTexture, settings.ReflectionTexture());
    settings.defaultReflectionMode = DefaultReflectionMode::Skybox;
    EXPECT_EQ(settings.skyReflection, settings.ReflectionTexture());
}

} // namespace
} // namespace limn::test
