#include "Mentions.h"
#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"
#include "core/FileSizeLimit.h"

#include <gmock/gmock.h>
#include <limn/features/Features.h>
#include <set>

// What is written is built and drawn by tests/consumer.

namespace limn::test
{

namespace
{

CommandRun RunNewFeature(const std::string& name, const std::string& folder)
{
    return RunCommand({"new", "feature", name, "-o", folder});
}

} // namespace

TEST(NewCommand, WritesAFeatureOfThatName)
{
    const WorkingFolder working;
    const CommandRun run = RunNewFeature("DepthFog", "a/fog");
    EXPECT_EQ(0, run.exitCode);
    EXPECT_EQ("", run.err);
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator("a/fog"))
    {
        const std::string file = entry.path().filename().string();
        files.insert(file);
        EXPECT_THAT(run.out, testing::HasSubstr("a/fog/" + file + "\n"));
        EXPECT_THAT(ReadText(entry.path()), testing::Not(testing::HasSubstr("@"))) << file;
    }
    EXPECT_EQ(
        (std::set<std::string>{"CMakeLists.txt", "DepthFog.profile.yaml", "DepthFog.scene.yaml",
                               "DepthFog.shader", "DepthFogRendererFeature.cpp",
                               "DepthFogRendererFeature.h", "DepthFogTest.cpp", "README.md"}),
        files);
    EXPECT_EQ(0, RunCommand({"shader", "a/fog/DepthFog.shader"}).exitCode);
    EXPECT_EQ(10, std::ranges::count(ReadText("a/fog/README.md"), '\n'));
}

TEST(NewCommand, WritesInTheStyleOfUnity6)
{
    const WorkingFolder working;
    const CommandRun run =
        RunCommand({"new", "feature", "DepthFog", "--style", "unity6", "-o", "fog"});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_EQ("", run.err);
    EXPECT_EQ(8, std::ranges::distance(std::filesystem::directory_iterator("fog"),
                                       std::filesystem::directory_iterator()));
    const std::string source = ReadText("fog/DepthFogRendererFeature.cpp");
    EXPECT_THAT(source,
                testing::HasSubstr("AddRasterRenderPass<PassData>(\"DepthFog\", passData)"));
    EXPECT_THAT(source, testing::Not(testing::HasSubstr("void Execute(")));
    EXPECT_THAT(source, testing::Not(testing::HasSubstr("@")));
    EXPECT_EQ(10, std::ranges::count(ReadText("fog/README.md"), '\n'));
    EXPECT_EQ(2, RunCommand({"new", "feature", "A", "--style", "urp12", "-o", "a"}).exitCode);
}

TEST(NewCommand, WritesOverNothing)
{
    const WorkingFolder working;
    working.folder.Write("mine.txt", "mine");
    const CommandRun run = RunNewFeature("DepthFog", ".");
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(LinesOf(run.err),
                testing::ElementsAre(Mentions(".:", "files already", "new folder")));
    EXPECT_EQ("mine", ReadText("mine.txt"));
    EXPECT_FALSE(std::filesystem::exists("CMakeLists.txt"));
    EXPECT_EQ("mine.txt: error: the folder cannot be made: Not a directory\n",
              RunNewFeature("DepthFog", "mine.txt").err);
    EXPECT_EQ("mine.txt/a: error: the folder cannot be made: Not a directory\n",
              RunNewFeature("DepthFog", "mine.txt/a").err);
}

TEST(NewCommand, LeavesNothingWhereThereIsNoRoom)
{
    const WorkingFolder working;
    std::filesystem::create_directory("empty");
    working.folder.Write("Fog.cs", "using UnityEngine.Rendering.Universal;\n"
                                   "class Fog : ScriptableRendererFeature { }\n");
    for (const std::string folder : {"fog", "empty"})
    {
        for (const std::vector<std::string>& words :
             {std::vector<std::string>{"new", "feature", "DepthFog", "-o", folder},
              std::vector<std::string>{"port", "Fog.cs", "-o", folder}})
        {
            const bool isNew = folder == "fog";
            {
                const FileSizeLimit limit(2000); // which the first files keep to
                const CommandRun run = RunCommand(words);
                EXPECT_EQ(3, run.exitCode);
                EXPECT_THAT(run.err, testing::HasSubstr("cannot be written: File too large"));
                EXPECT_EQ("", run.out);
            }
            EXPECT_EQ(!isNew, std::filesystem::exists(folder)) << words[0];
            EXPECT_TRUE(isNew || std::filesystem::is_empty(folder)) << words[0];
        }
    }
    EXPECT_EQ(0, RunNewFeature("DepthFog", "fog").exitCode) << "once there is room";
}

TEST(NewCommand, RefusesANameThatIsNoClass)
{
    const WorkingFolder working;
    for (const std::string name : {"depthFog", "Depth Fog", "Depth-Fog", "9Fog", "", "Ö", "../Fog"})
    {
        const CommandRun run = RunNewFeature(name, "fog");
        EXPECT_EQ(2, run.exitCode) << name;
        EXPECT_THAT(LinesOf(run.err), testing::ElementsAre(Mentions("error:", "'" + name + "'",
                                                                    "capital letter", "DepthFog")));
    }
    EXPECT_EQ(2, RunNewFeature(std::string(41, 'A'), "fog").exitCode);
    EXPECT_THAT(LinesOf(RunNewFeature("WideOutline", "fog").err),
                testing::ElementsAre(Mentions("error:", "has a feature", "'WideOutline'")));
    EXPECT_FALSE(std::filesystem::exists("fog"));
}

TEST(NewFile, IsASceneInWhichAnObjectIsOutlined)
{
    const WorkingFolder working;
    const CommandRun run = RunCommand({"new", "scene", "hero"});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_EQ("hero.profile.yaml\nhero.scene.yaml\n", run.out);
    const CommandRun explained = RunCommand({"explain", "hero.scene.yaml", "--object", "Sphere"});
    EXPECT_EQ(0, explained.exitCode);
    EXPECT_EQ("", explained.err);
    EXPECT_THAT(explained.out, testing::HasSubstr("Outline"));
    EXPECT_EQ(0,
              RunCommand({"set", "hero.profile.yaml", "StrokeOutline.m_OutlineWidth=6"}).exitCode);
}

TEST(NewFile, HoldsEveryComponentWithValuesThatAreRead)
{
    const WorkingFolder working;
    VolumeComponentRegistry components;
    RegisterVolumeComponents(components);
    std::vector<std::string> words{"new", "profile", "all.profile.yaml"};
    for (const std::string_view name : components.names())
    {
        words.emplace_back(name);
    }
    ASSERT_EQ(0, RunCommand(words).exitCode);
    const CommandRun inspected = RunCommand({"inspect", "all.profile.yaml"});
    EXPECT_EQ(0, inspected.exitCode);
    EXPECT_EQ("", inspected.err);
    for (const std::string_view name : components.names())
    {
        EXPECT_THAT(inspected.out, testing::HasSubstr("  " + std::string(name) + "\n"));
    }
}

TEST(NewFile, IsAMaterialOfEveryShaderThatDrawsWithIt)
{
    const WorkingFolder working;
    int count = 0;
    for (const std::string_view shader : ShippedShaders().names())
    {
        const std::string name = "m" + std::to_string(++count);
        ASSERT_EQ(0, RunCommand({"new", "material", name, std::string(shader)}).exitCode) << shader;
        working.folder.Write("a.scene.yaml", "camera: {}\nmaterials: {a: " + name +
                                                 ".material.yaml}\n"
                                                 "objects: [{name: A, mesh: cube, material: a}]\n");
        const CommandRun run = RunCommand({"inspect", "a.scene.yaml"});
        EXPECT_EQ(0, run.exitCode) << shader << ": " << run.err;
    }
    EXPECT_GT(count, 20);
}

TEST(NewFile, ReplacesNothing)
{
    const WorkingFolder working;
    working.folder.Write("hero.profile.yaml", "# mine\n");
    const CommandRun run = RunCommand({"new", "scene", "hero"});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err, Mentions("hero.profile.yaml:", "there already"));
    EXPECT_EQ("# mine\n", ReadText("hero.profile.yaml"));
    EXPECT_FALSE(std::filesystem::exists("hero.scene.yaml"));
}

TEST(NewFile, RefusesWhatBelongsToOtherKindsAndUnknownNames)
{
    const WorkingFolder working;
    EXPECT_EQ(2, RunCommand({"new", "scene", "a", "-o", "b"}).exitCode);
    EXPECT_EQ(2, RunCommand({"new", "scene", "a", "Bloom"}).exitCode);
    EXPECT_EQ(2, RunCommand({"new", "material", "a", "B", "C"}).exitCode);
    EXPECT_EQ(2, RunCommand({"new", "feature", "Fog"}).exitCode);
    EXPECT_EQ(2, RunCommand({"new", "feature", "Fog", "x", "-o", "d"}).exitCode);
    const CommandRun component = RunCommand({"new", "profile", "a", "Blom"});
    EXPECT_EQ(1, component.exitCode);
    EXPECT_THAT(component.err, testing::HasSubstr("did you mean 'Bloom'?"));
    EXPECT_EQ(1, RunCommand({"new", "material", "a", "Nothing/Such"}).exitCode);
    EXPECT_TRUE(std::filesystem::is_empty("."));
}

} // namespace limn::test
