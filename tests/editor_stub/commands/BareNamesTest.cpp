#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"

#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

/// Every verb that takes files and no device, run from inside the files' own folder.
class BareNames : public testing::Test
{
protected:
    BareNames() { WriteProject(working.folder); }

    /// Runs with exit code 0 and without a word to stderr.
    static std::string Run(const std::vector<std::string>& args)
    {
        const CommandRun run = RunCommand(args);
        EXPECT_EQ(0, run.exitCode);
        EXPECT_EQ("", run.err);
        return run.out;
    }

    WorkingFolder working;
};

} // namespace

TEST_F(BareNames, DoForShader)
{
    EXPECT_THAT(Run({"shader", "a.shader"}), testing::StartsWith("Shader \"A\" (a.shader)\n"));
    EXPECT_EQ("2 files: 2 parsed (100.0 %); 1 of 1 pass compiled (100.0 %)\n",
              Run({"shader", "a.shader", "b.shader"}));
    EXPECT_EQ("2 files: 2 parsed (100.0 %); 1 of 1 pass compiled (100.0 %)\n",
              Run({"shader", "."}));
    EXPECT_EQ("emitted/A.0.vert.spv\nemitted/A.0.frag.spv\n",
              Run({"shader", "a.shader", "--emit", "spirv", "-o", "emitted"}));
}

TEST_F(BareNames, DoForAFolderOfShaders)
{
    std::filesystem::create_directory("shaders");
    std::filesystem::copy_file("a.hlsl", "shaders/a.hlsl");
    std::filesystem::copy_file("a.shader", "shaders/a.shader");
    std::filesystem::copy_file("b.shader", "shaders/b.shader");
    EXPECT_EQ("2 files: 2 parsed (100.0 %); 1 of 1 pass compiled (100.0 %)\n",
              Run({"shader", "shaders"}));
}

TEST_F(BareNames, FindTheProjectAroundTheWorkingFolder)
{
    std::filesystem::create_directories("Assets/Inner");
    std::filesystem::rename("b.shader", "Assets/b.shader");
    std::filesystem::rename("a.shader", "Assets/Inner/a.shader");
    std::filesystem::rename("a.hlsl", "Assets/Inner/a.hlsl");
    std::filesystem::current_path("Assets/Inner");
    EXPECT_THAT(Run({"shader", "a.shader"}), testing::StartsWith("Shader \"A\" (a.shader)\n"));
}

TEST_F(BareNames, DoForExplain)
{
    EXPECT_THAT(Run({"explain", "s.scene.yaml"}), testing::HasSubstr("m_OutlineWidth"));
    EXPECT_THAT(Run({"explain", "s.scene.yaml", "--object", "Piece"}),
                testing::StartsWith("Piece\n"));
}

TEST_F(BareNames, DoForInspect)
{
    EXPECT_THAT(Run({"inspect", "s.scene.yaml"}), testing::StartsWith("volume 'All': global"));
    EXPECT_THAT(Run({"inspect", "p.profile.yaml"}), testing::StartsWith("  ScreenSpaceOutline\n"));
}

TEST_F(BareNames, DoForSet)
{
    EXPECT_EQ("ScreenSpaceOutline.m_OutlineWidth: 4 → 7\n",
              Run({"set", "p.profile.yaml", "ScreenSpaceOutline.m_OutlineWidth=7"}));
    EXPECT_EQ("ScreenSpaceOutline:\n  m_OutlineWidth: 7\n", ReadText("p.profile.yaml"));
}

} // namespace limn::test
