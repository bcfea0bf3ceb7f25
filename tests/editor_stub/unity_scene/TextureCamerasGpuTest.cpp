// Cameras of a Unity scene that draw into render textures, which objects of the scene show.

#include "Mentions.h"
#include "commands/CommandRun.h"
#include "vulkan/GpuTestDevice.h"

#include <gmock/gmock.h>
#include <limn/core/Image.h>

namespace limn::test
{
namespace
{

using testing::HasSubstr;
using testing::Not;

/// An orthographic camera that sees a square of two metres.
std::string CameraAt(const std::string& id, const std::string& name, float x,
                     const std::string& background, const std::string& more)
{
    return "--- !u!1 &" + id + "\nGameObject: {m_Name: " + name + ", m_IsActive: 1}\n--- !u!4 &" +
           id + "4\nTransform:\n  m_GameObject: {fileID: " + id +
           "}\n  m_LocalPosition: {x: " + std::to_string(x) +
           ", y: 0, z: -5}\n  m_Father: {fileID: 0}\n--- !u!20 &" + id +
           "5\nCamera:\n  m_GameObject: {fileID: " + id +
           "}\n  m_ClearFlags: 2\n  m_BackGroundColor: {" + background +
           "}\n  orthographic: 1\n  orthographic size: 1\n" + more;
}

/// A quad in front of the cameras.
std::string QuadAt(const std::string& id, float x, float y, float size, const std::string& material)
{
    const std::string s = std::to_string(size);
    return "--- !u!1 &" + id + "\nGameObject: {m_Name: Quad, m_IsActive: 1}\n--- !u!4 &" + id +
           "4\nTransform:\n  m_GameObject: {fileID: " + id +
           "}\n  m_LocalPosition: {x: " + std::to_string(x) + ", y: " + std::to_string(y) +
           ", z: 0}\n  m_LocalScale: {x: " + s + ", y: " + s +
           ", z: 1}\n  m_Father: {fileID: 0}\n--- !u!33 &" + id +
           "3\nMeshFilter:\n  m_GameObject: {fileID: " + id +
           "}\n  m_Mesh: {fileID: 10210, guid: 0000000000000000e000000000000000, type: 0}\n"
           "--- !u!23 &" +
           id + "2\nMeshRenderer:\n  m_GameObject: {fileID: " + id +
           "}\n  m_Enabled: 1\n  m_Materials:\n  - {fileID: 2100000, guid: " + material +
           ", type: 2}\n";
}

constexpr const char* k_Target =
    "  m_TargetTexture: {fileID: 8400000, guid: dddddddddddddddddddddddddddddddd, type: 2}\n";
constexpr const char* k_Shown = "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"; ///< shows the render texture
constexpr const char* k_Green = "cccccccccccccccccccccccccccccccc";
constexpr const char* k_RedSky = "r: 1, g: 0, b: 0, a: 1";
constexpr const char* k_BlueSky = "r: 0, g: 0, b: 1, a: 1";

class TextureCameras : public GpuTest
{
protected:
    void SetUp() override
    {
        GpuTest::SetUp();
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

    void Write(const std::string& name, const std::string& text, const std::string& guid)
    {
        m_Folder.Write(name, text);
        m_Folder.Write(name + ".meta", "guid: " + guid + "\n");
    }
    void WriteAsset(const std::string& name, const std::string& text, const std::string& guid)
    {
        Write(name, "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n" + text, guid);
    }
    void WriteTarget(const std::string& fields)
    {
        WriteAsset("Assets/Screen.renderTexture",
                   "--- !u!84 &8400000\nRenderTexture:\n  m_Name: Screen\n  m_Width: 8\n"
                   "  m_Height: 8\n  m_TextureSettings: {m_FilterMode: 0}\n" +
                       fields,
                   "dddddddddddddddddddddddddddddddd");
    }

    /// @return what limn says
    std::string Draw(const std::string& scene)
    {
        m_Folder.Write("Assets/Main.unity", "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n" + scene);
        const CommandRun run = RunCommand({"render", m_Folder / "Assets/Main.unity", "-o",
                                           m_Folder / "out.png", "--size", "16x16", "--validate"});
        EXPECT_EQ(0, run.exitCode) << run.err;
        m_Picture = ReadPng(m_Folder / "out.png");
        return run.err;
    }
    /// Returns the colour in the middle of a quarter: "0 255 0". 0, 0 is at the bottom left.
    std::string Quarter(int x, int y) const
    {
        const std::size_t texel =
            static_cast<std::size_t>((12 - y * 8) * m_Picture.width + x * 8 + 4);
        std::string color;
        for (std::size_t i = 0; i < 3; ++i)
        {
            color += (i ? " " : "") +
                     std::to_string(std::to_integer<int>(m_Picture.texels[4 * texel + i]));
        }
        return color;
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
    TemporaryFolder m_Folder;
    Image m_Picture;
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
