#include "PluginRun.h"

#include <gmock/gmock.h>
#include <limn/core/Image.h>

namespace limn::test
{

TEST(PluginGpu, DrawsWithItsShaderWhatItsComponentSays)
{
    const PluginFolder folder;
    ASSERT_THAT(folder.Run("render s.scene.yaml -o o.png --plugin probe.so"),
                testing::EndsWith("exit 0\n"));
    const Image image = ReadPng("o.png");
    ASSERT_EQ(64u * 4, image.texels.size());
    for (std::size_t i = 0; i < image.texels.size(); i += 4)
    {
        // sRGB shows a light of 0.75 as 1.055 * 0.75^(1 / 2.4) - 0.055 = 0.8809 of 255.
        EXPECT_NEAR(224.6, std::to_integer<int>(image.texels[i]), 1.0);
        EXPECT_EQ(0, std::to_integer<int>(image.texels[i + 1]));
        EXPECT_EQ(0, std::to_integer<int>(image.texels[i + 2]));
    }
}

TEST(PluginGpu, IsInTheSceneThatReportMeasures)
{
    const PluginFolder folder;
    const std::string arguments = "report s.scene.yaml -o report --quick";
    EXPECT_THAT(folder.Run(arguments), testing::HasSubstr("unknown feature 'ProbeFeature'"));
    EXPECT_THAT(folder.Run(arguments + " --plugin probe.so"),
                testing::HasSubstr("no active feature outlines anything"));
}

TEST(PluginGpu, HasTechniquesThatReportKnows)
{
    const PluginFolder folder;
    folder.Write("o.scene.yaml", "size: [16, 16]\ncamera: {position: [0, 0, -3]}\n"
                                 "renderer: {features: [{type: StrokeOutlineRendererFeature}]}\n"
                                 "objects: [{name: ball, mesh: sphere}]\n");
    const std::string arguments = "report o.scene.yaml -o report --technique Redpaint";
    EXPECT_THAT(folder.Run(arguments), testing::HasSubstr("unknown technique 'Redpaint' (known: "));
    EXPECT_THAT(folder.Run(arguments + " --plugin probe.so"),
                testing::HasSubstr("did you mean 'Red paint'?"));
}

// Unity logs what a feature throws, and goes on.
TEST(PluginGpu, IsLeftOutOfAUnityScenesPictureWhereItThrows)
{
    const PluginFolder folder;
    const std::string head = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";
    const auto write = [&](const std::string& name, const std::string& text)
    {
        std::filesystem::create_directories(std::filesystem::path(name).parent_path());
        folder.Write(name, head + text);
    };
    write("ProjectSettings/GraphicsSettings.asset",
          "--- !u!30 &1\nGraphicsSettings:\n  m_CustomRenderPipeline: {fileID: 11400000, guid: "
          "a1, type: 2}\n");
    write("Assets/P.asset", "--- !u!114 &11400000\nMonoBehaviour:\n  m_MSAA: 1\n"
                            "  m_RendererDataList:\n  - {fileID: 11400000, guid: a2, type: 2}\n");
    folder.Write("Assets/P.asset.meta", "guid: a1\n");
    folder.Write("Assets/R.asset.meta", "guid: a2\n");
    folder.Write("Assets/ProbeFeature.cs.meta", "guid: a3\n");
    write("Assets/Main.unity",
          "--- !u!1 &1\nGameObject: {m_Name: Camera, m_IsActive: 1}\n--- !u!4 &2\nTransform:\n"
          "  m_GameObject: {fileID: 1}\n--- !u!20 &3\nCamera:\n  m_GameObject: {fileID: 1}\n"
          "  m_ClearFlags: 2\n  m_BackGroundColor: {r: 0, g: 0, b: 1, a: 1}\n");
    for (const char* fault : {"2", "5"}) // in AddRenderPasses, in Execute
    {
        write("Assets/R.asset", std::string("--- !u!114 &5\nMonoBehaviour:\n  m_Script: {fileID: "
                                            "11500000, guid: a3, type: 3}\n  m_Name: Red\n"
                                            "  m_Active: 1\n  fault: ") +
                                    fault +
                                    "\n--- !u!114 &11400000\nMonoBehaviour:\n  m_Name: R\n"
                                    "  m_RendererFeatures:\n  - {fileID: 5}\n");
        EXPECT_THAT(folder.Run("render Assets/Main.unity -o o.png --size 8x8 --plugin probe.so"),
                    testing::AllOf(testing::EndsWith("exit 0\n"),
                                   testing::HasSubstr("'Red' threw in "),
                                   testing::HasSubstr("note: Red: it is not drawn")));
        const Image image = ReadPng("o.png");
        EXPECT_EQ(0, std::to_integer<int>(image.texels[0]));
        EXPECT_EQ(255, std::to_integer<int>(image.texels[2])) << "the camera's own background";
    }
}

} // namespace limn::test
