// Cameras of a Unity scene that draw into render textures, which objects of the scene show.

#include "Mentions.h"
#include "unity_scene/GpuTestOfAProject.h"

namespace limn::test
{
namespace
{

using testing::HasSubstr;
using testing::Not;

constexpr const char* k_Target =
    "  m_TargetTexture: {fileID: 8400000, guid: dddddddddddddddddddddddddddddddd, type: 2}\n";
constexpr const char* k_Shown = "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"; ///< shows the render texture
constexpr const char* k_Green = "cccccccccccccccccccccccccccccccc";
constexpr const char* k_RedSky = "r: 1, g: 0, b: 0, a: 1";
constexpr const char* k_BlueSky = "r: 0, g: 0, b: 1, a: 1";

class TextureCameras : public GpuTestOfAProject
{
protected:
    void SetUp() override
    {
        GpuTestOfAProject::SetUp();
        const std::string material =
            "--- !u!21 &2100000\nMaterial:\n  m_Shader: {fileID: 4800000, guid: "
            "650dd9526735d5b46b79224bc6e94025, type: 3}\n  m_SavedProperties:\n";
        WriteAsset("Assets/Shown.mat",
                   material + "    m_TexEnvs:\n    - _BaseMap:\n        m_Texture: {fileID: "
                              "8400000, guid: dddddddddddddddddddddddddddddddd, type: 2}\n        "
                              "m_Scale: {x: 1, y: 1}\n",
                   k_Shown);
        WriteAsset("Assets/Green.mat",
                   material + "    m_Colors:\n    - _BaseColor: {r: 0, g: 1, b: 0, a: 1}\n",
                   k_Green);
        WriteTarget("  serializedVersion: 6\n  m_AntiAliasing: 1\n  m_ColorFormat: 8\n");
    }

    void WriteTarget(const std::string& fields)
    {
        WriteAsset("Assets/Screen.renderTexture",
                   "--- !u!84 &8400000\nRenderTexture:\n  m_Name: Screen\n  m_Width: 8\n"
                   "  m_Height: 8\n  m_TextureSettings: {m_FilterMode: 0}\n" +
                       fields,
                   "dddddddddddddddddddddddddddddddd");
    }

    /// Expects the picture of the second camera: a green quad at the bottom left on blue.
    void ExpectSecondPicture() const
    {
        EXPECT_EQ("0 255 0", Quarter(0, 0));
        EXPECT_EQ("0 0 255", Quarter(1, 0));
        EXPECT_EQ("0 0 255", Quarter(0, 1));
        EXPECT_EQ("0 0 255", Quarter(1, 1));
    }

    const std::string m_Main = CameraAt("1", "Main", 0, k_RedSky, "");
    const std::string m_Second = CameraAt("2", "Second", 100, k_BlueSky, k_Target);
    const std::string m_Screen = QuadAt("3", 0, 0, 2, k_Shown);
    const std::string m_Corner = QuadAt("4", 99.5f, -0.5f, 1, k_Green);
};

TEST_F(TextureCameras, FillTheTexturesThatObjectsShow)
{
    const std::string said = Draw(m_Main + m_Second + m_Screen + m_Corner);
    ExpectSecondPicture();
    EXPECT_THAT(said, Not(HasSubstr("Screen.renderTexture")));
    EXPECT_THAT(said, Not(HasSubstr("cameras besides")));
}

TEST_F(TextureCameras, DrawIntoTexturesOfOldVersionsAndWithSamples)
{
    WriteTarget("  m_AntiAliasing: 2\n  m_ColorFormat: 0\n  m_SRGB: 1\n");
    Draw(m_Main + m_Second + m_Screen + m_Corner);
    ExpectSecondPicture();
}

// The colour of an object that shows the texture of the camera that sees it is undefined. The rest
// of the picture must be right all the same.
TEST_F(TextureCameras, MaySeeTheirOwnTexture)
{
    Draw(m_Main + m_Second + m_Screen + m_Corner + QuadAt("6", 100.5f, 0.5f, 1, k_Shown));
    EXPECT_EQ("0 255 0", Quarter(0, 0));
    EXPECT_EQ("0 0 255", Quarter(1, 0));
}

TEST_F(TextureCameras, GiveThePictureWhereNoneDrawsOntoTheScreen)
{
    const std::string said = Draw(m_Second + m_Corner);
    ExpectSecondPicture();
    EXPECT_THAT(said, Mentions("no camera draws onto the screen", "Second"));
}

TEST_F(TextureCameras, AreMissedWhereATextureIsShown)
{
    EXPECT_THAT(Draw(m_Main + m_Screen), Mentions("_BaseMap", "no camera of the scene draws into "
                                                              "Screen.renderTexture"));
    EXPECT_EQ("255 255 255", Quarter(0, 0)) << "the shader's own";
}

TEST_F(TextureCameras, SayWhatIsWrongWithTheirTexture)
{
    WriteTarget("  serializedVersion: 6\n  m_AntiAliasing: 1\n  m_ColorFormat: 0\n");
    EXPECT_THAT(Draw(m_Main + m_Second + m_Screen),
                Mentions("Screen.renderTexture", "the format 0", "no colour"));
    WriteTarget("  serializedVersion: 6\n  m_AntiAliasing: 1\n  m_ColorFormat: 8\n"
                "  m_Dimension: 4\n");
    EXPECT_THAT(Draw(m_Main + m_Second + m_Screen), Mentions("Screen.renderTexture", "2D"));
}

} // namespace
} // namespace limn::test
