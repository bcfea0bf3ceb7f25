#include "Mentions.h"
#include "unity_scene/UnityScene.h"

#include "TemporaryFolder.h"
#include <gmock/gmock.h>
#include <limn/core/Material.h>

namespace limn::test
{
namespace
{

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* k_DefaultSky =
    "  m_SkyboxMaterial: {fileID: 10304, guid: 0000000000000000f000000000000000, type: 0}\n";

/// A scene of a camera and RenderSettings.
class UnityRenderSettings : public testing::Test
{
protected:
    const Scene& Load(const std::string& fields)
    {
        m_Folder.Write("ProjectSettings/ProjectSettings.asset", "%YAML 1.1\n");
        m_Folder.Write("Assets/Main.unity",
                       "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n"
                       "--- !u!104 &2\nRenderSettings:\n" +
                           fields +
                           "--- !u!1 &1\nGameObject:\n  m_Name: Camera\n"
                           "  m_TagString: MainCamera\n  m_IsActive: 1\n"
                           "--- !u!4 &14\nTransform:\n  m_GameObject: {fileID: 1}\n"
                           "  m_Father: {fileID: 0}\n"
                           "--- !u!20 &12\nCamera:\n  m_GameObject: {fileID: 1}\n");
        m_Asset = LoadScene(m_Folder.path(), m_Assets);
        return m_Asset->scene;
    }
    /// Those of RenderSettings.
    std::vector<std::string> Notes() const
    {
        std::vector<std::string> notes;
        for (const Diagnostic& note : m_Asset->notes)
        {
            if (note.message.starts_with("RenderSettings"))
            {
                notes.push_back(note.message);
            }
        }
        return notes;
    }

    TemporaryFolder m_Folder;
    AssetContext m_Assets;
    std::optional<SceneAsset> m_Asset;
};

TEST_F(UnityRenderSettings, LightByTheSkyAndMirrorItUnlessTheySayOtherwise)
{
    const Scene& scene = Load(k_DefaultSky);
    EXPECT_EQ(AmbientMode::Skybox, scene.ambientMode);
    EXPECT_EQ(DefaultReflectionMode::Skybox, scene.defaultReflectionMode);
    EXPECT_EQ(128, scene.defaultReflectionResolution);
    EXPECT_EQ(1.0f, scene.ambientIntensity);
    EXPECT_FALSE(scene.fog);
    ASSERT_NE(nullptr, scene.skybox);
    // Until it is drawn, by the average that Unity has baked.
    EXPECT_EQ(glm::vec3(0.18028f, 0.22571f, 0.30692f), scene.AmbientLight().Evaluate({0, 1, 0}));
    EXPECT_THAT(Notes(), IsEmpty());

    Load(std::string(k_DefaultSky) + "  m_AmbientIntensity: 0.5\n"
                                     "  m_IndirectSpecularColor: {r: 1, g: 0.5, b: 0.25, a: 1}\n");
    EXPECT_EQ(glm::vec3(0.5f, 0.25f, 0.125f), m_Asset->scene.AmbientLight().Evaluate({0, 1, 0}));
}

TEST_F(UnityRenderSettings, HaveOneColorWhereThereIsNoSky)
{
    const Scene& scene = Load("  m_AmbientMode: 0\n  m_SkyboxMaterial: {fileID: 0}\n"
                              "  m_AmbientSkyColor: {r: 0.5, g: 0.25, b: 0, a: 1}\n");
    EXPECT_EQ(AmbientMode::Flat, scene.ambientMode);
    EXPECT_EQ((Color{0.5f, 0.25f, 0.0f, 1.0f}), scene.ambientLight);
}

TEST_F(UnityRenderSettings, HaveNoSkyWhereItsMaterialIsMissing)
{
    const Scene& scene = Load("  m_SkyboxMaterial: {fileID: 2100000, guid: "
                              "cccccccccccccccccccccccccccccccc, type: 2}\n");
    EXPECT_EQ(nullptr, scene.skybox);
    EXPECT_THAT(Notes(), ElementsAre(HasSubstr("background")));
}

TEST_F(UnityRenderSettings, HaveThreeColorsOrOneByTheMode)
{
    const std::string colors = "  m_AmbientSkyColor: {r: 0.5, g: 0.25, b: 0, a: 1}\n"
                               "  m_AmbientEquatorColor: {r: 0, g: 0.5, b: 0.25, a: 1}\n"
                               "  m_AmbientGroundColor: {r: 0.25, g: 0, b: 0.5, a: 1}\n";
    Load("  m_AmbientMode: 1\n" + colors);
    EXPECT_EQ(AmbientMode::Trilight, m_Asset->scene.ambientMode);
    EXPECT_EQ((Color{0.5f, 0.25f, 0.0f, 1.0f}), m_Asset->scene.ambientSkyColor);
    EXPECT_EQ((Color{0.0f, 0.5f, 0.25f, 1.0f}), m_Asset->scene.ambientEquatorColor);
    EXPECT_EQ((Color{0.25f, 0.0f, 0.5f, 1.0f}), m_Asset->scene.ambientGroundColor);
    Load("  m_AmbientMode: 3\n" + colors);
    EXPECT_EQ(AmbientMode::Flat, m_Asset->scene.ambientMode);
    EXPECT_EQ((Color{0.5f, 0.25f, 0.0f, 1.0f}), m_Asset->scene.ambientLight);
    EXPECT_THAT(Notes(), IsEmpty());
    Load("  m_AmbientMode: 4\n" + colors);
    EXPECT_EQ(AmbientMode::Flat, m_Asset->scene.ambientMode);
    EXPECT_THAT(Notes(), ElementsAre(Mentions("m_AmbientMode:", "custom light", "not read")));
}

TEST_F(UnityRenderSettings, HaveFogOfThreeModes)
{
    const Scene& scene =
        Load("  m_Fog: 1\n  m_FogColor: {r: 0.5, g: 0.25, b: 1, a: 1}\n  m_FogMode: 1\n"
             "  m_FogDensity: 0.125\n  m_LinearFogStart: -5\n  m_LinearFogEnd: 60\n");
    EXPECT_TRUE(scene.fog);
    EXPECT_EQ(FogMode::Linear, scene.fogMode);
    EXPECT_EQ((Color{0.5f, 0.25f, 1.0f, 1.0f}), scene.fogColor);
    EXPECT_EQ(0.125f, scene.fogDensity);
    EXPECT_EQ(-5.0f, scene.fogStartDistance);
    EXPECT_EQ(60.0f, scene.fogEndDistance);
    EXPECT_EQ(FogMode::Exponential, Load("  m_Fog: 1\n  m_FogMode: 2\n").fogMode);
    EXPECT_EQ(FogMode::ExponentialSquared, Load("  m_Fog: 1\n  m_FogMode: 3\n").fogMode);
    EXPECT_THAT(Notes(), IsEmpty());
}

TEST_F(UnityRenderSettings, SayWhatIsMirroredThatLimnCannotRead)
{
    const Scene& scene =
        Load("  m_DefaultReflectionMode: 1\n  m_ReflectionIntensity: 0.5\n"
             "  m_CustomReflection: {fileID: 8900000, guid: cccccccccccccccccccccccccccccccc}\n");
    EXPECT_EQ(DefaultReflectionMode::Custom, scene.defaultReflectionMode);
    EXPECT_EQ(0.5f, scene.reflectionIntensity);
    EXPECT_THAT(Notes(), ElementsAre(Mentions("m_CustomReflection:", "the cube's guid", "cccc",
                                              "nothing is mirrored")));
    Load("  m_DefaultReflectionMode: 1\n  m_CustomReflection: {fileID: 0}\n");
    EXPECT_THAT(Notes(), IsEmpty());
}

TEST_F(UnityRenderSettings, MirrorTheCubeThatAPictureIs)
{
    const std::string custom =
        "  m_DefaultReflectionMode: 1\n"
        "  m_CustomReflection: {fileID: 8900000, guid: cccccccccccccccccccccccccccccccc}\n";
    std::filesystem::create_directories(m_Folder.path() / "Assets");
    WritePng(m_Folder.path() / "Assets/room.png",
             {8, 6, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(8 * 6 * 4)});
    const std::string meta = "guid: cccccccccccccccccccccccccccccccc\nTextureImporter:\n";
    m_Folder.Write("Assets/room.png.meta", meta + "  textureShape: 2\n");
    const Scene& scene = Load(custom);
    EXPECT_THAT(Notes(), IsEmpty());
    ASSERT_NE(scene.customReflectionTexture, nullptr);
    EXPECT_EQ(scene.customReflectionTexture->DescribeSize(), "2x2 Cube");

    m_Folder.Write("Assets/room.png.meta", meta + "  textureShape: 1\n");
    m_Assets.Forget(m_Folder.path() / "Assets/room.png.meta");
    EXPECT_EQ(Load(custom).customReflectionTexture, nullptr);
    EXPECT_THAT(Notes(), ElementsAre(Mentions("m_CustomReflection:", "room.png", "no cube")));
}

TEST_F(UnityRenderSettings, KeepWhatIsOutOfRangeAsItIs)
{
    const Scene& scene =
        Load("  m_AmbientMode: 2\n  m_AmbientIntensity: -1\n  m_FogMode: 0\n"
             "  m_FogDensity: -0.5\n  m_LinearFogStart: 1e30\n  m_ReflectionIntensity: 9\n"
             "  m_DefaultReflectionMode: 5\n  m_DefaultReflectionResolution: 100\n");
    EXPECT_EQ(1.0f, scene.ambientIntensity);
    EXPECT_EQ(FogMode::ExponentialSquared, scene.fogMode);
    EXPECT_EQ(0.01f, scene.fogDensity);
    EXPECT_EQ(0.0f, scene.fogStartDistance);
    EXPECT_EQ(1.0f, scene.reflectionIntensity);
    EXPECT_EQ(DefaultReflectionMode::Skybox, scene.defaultReflectionMode);
    EXPECT_EQ(128, scene.defaultReflectionResolution);
    EXPECT_EQ(8u, Notes().size());
    EXPECT_THAT(Notes(), Contains(Mentions("RenderSettings.m_AmbientMode:", "2", "0, 1, 3, 4",
                                           "left at 0")));
    EXPECT_THAT(Notes(),
                Contains(Mentions("RenderSettings.m_FogMode:", "0", "1, 2, 3", "left at 3")));
    EXPECT_THAT(Notes(), Contains(Mentions("RenderSettings.m_DefaultReflectionResolution:", "100",
                                           "power of two", "2048", "left at 128")));
}

} // namespace
} // namespace limn::test
