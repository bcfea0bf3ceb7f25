#include "SceneFolder.h"

#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

/// A Unity project with a scene file beside its Assets folder.
class PipelineVersion : public testing::Test
{
protected:
    PipelineVersion()
    {
        const std::string head = "%YAML 1.1\n--- !u!114 &1\nMonoBehaviour:\n  m_Name: A\n";
        folder.Write("Assets/R.asset", head + "  m_RendererFeatures: []\n");
        for (const char* number : {"5", "9", "11", "12"})
        {
            folder.Write("Assets/P" + std::string(number) + ".asset",
                         head + "  m_MSAA: 1\n  k_AssetVersion: " + number + "\n");
        }
    }

    void WriteManifest(const std::string& version) const
    {
        folder.Write("Packages/manifest.json",
                     "{\"dependencies\": {\"com.unity.render-pipelines.universal\": \"" + version +
                         "\"}}");
    }

    int VersionWith(const std::string& keys) { return folder.LoadWithCamera(keys).pipelineVersion; }

    SceneFolder folder;
};

} // namespace

TEST_F(PipelineVersion, IsThatOfTheScene)
{
    WriteManifest("10.8.1");
    EXPECT_EQ(14, VersionWith(""));
    EXPECT_EQ(7, VersionWith("pipelineVersion: 7\n"));
    EXPECT_EQ(12, VersionWith("pipelineVersion: 12\nrenderPipelineAsset: Assets/P5.asset\n"
                              "renderer: Assets/R.asset\n"));
    EXPECT_THAT(folder.ProblemsOf("camera: {}\npipelineVersion: 18\n"),
                testing::ElementsAre("2:18: pipelineVersion: 18 is outside [7, 17]"));
}

TEST_F(PipelineVersion, IsThatOfTheProjectsPackage)
{
    WriteManifest("10.8.1");
    EXPECT_EQ(10, VersionWith("renderer: Assets/R.asset\n"));
    EXPECT_EQ(10, VersionWith("renderPipelineAsset: Assets/P11.asset\n"));
}

TEST_F(PipelineVersion, IsToldByAPipelineAssetWhereNoPackageIsNamed)
{
    for (const char* manifest : {"file:../urp", "6.9.0", "x", "14"})
    {
        WriteManifest(manifest);
        EXPECT_EQ(11, VersionWith("renderPipelineAsset: Assets/P5.asset\n")) << manifest;
        EXPECT_EQ(14, VersionWith("renderer: Assets/R.asset\n")) << manifest;
    }
    for (const char* broken : {"", "{\"dependencies\": [", "{\"dependencies\": []}", "[1]", "3"})
    {
        folder.Write("Packages/manifest.json", broken);
        EXPECT_EQ(12, VersionWith("renderPipelineAsset: Assets/P9.asset\n")) << broken;
    }
    EXPECT_EQ(14, VersionWith("renderPipelineAsset: Assets/P11.asset\n"));
    EXPECT_EQ(17, VersionWith("renderPipelineAsset: Assets/P12.asset\n"));
}

} // namespace limn::test
