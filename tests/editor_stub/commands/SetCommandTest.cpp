#include "Mentions.h"
#include "commands/CommandRun.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limn::test
{

TEST(LimnSet, ChangesTheValueAndPrintsWhatItWas)
{
    const TemporaryFolder folder;
    const auto file = folder.Write("a.profile.yaml", "ScreenSpaceOutline:\n"
                                                     "  m_OutlineWidth: 4 # pixels\n"
                                                     "  enable: true\n");
    const CommandRun run = RunCommand({"set", file.string(), "ScreenSpaceOutline.outlineWidth=6",
                                       "ScreenSpaceOutline.m_Enable=false"});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_EQ("ScreenSpaceOutline.m_OutlineWidth: 4 → 6\n"
              "ScreenSpaceOutline.m_Enable: true → false\n",
              run.out);
    EXPECT_EQ("", run.err);
    EXPECT_EQ("ScreenSpaceOutline:\n  m_OutlineWidth: 6 # pixels\n  enable: false\n",
              ReadText(file));
}

TEST(LimnSet, SaysWhereTheFileStaysAsItIs)
{
    const TemporaryFolder folder;
    const std::string text = "ScreenSpaceOutline: {outlineWidth: 4.0, active: false}\n";
    const auto file = folder.Write("a.profile.yaml", text);
    EXPECT_EQ("ScreenSpaceOutline.m_OutlineWidth: 4, as it was\n",
              RunCommand({"set", file.string(), "ScreenSpaceOutline.m_OutlineWidth=4"}).out);
    EXPECT_EQ(text, ReadText(file));
    EXPECT_EQ("ScreenSpaceOutline.active: false → true\n",
              RunCommand({"set", file.string(), "ScreenSpaceOutline.active=true"}).out);
}

TEST(LimnSet, LeavesTheFileIfOneOfTheValuesIsWrong)
{
    const TemporaryFolder folder;
    const std::string text = "ScreenSpaceOutline: {outlineWidth: 4, enable: true}\n";
    const auto file = folder.Write("a.profile.yaml", text);
    const CommandRun run = RunCommand({"set", file.string(), "ScreenSpaceOutline.enable=false",
                                       "ScreenSpaceOutline.outlineWidth=14"});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(LinesOf(run.err),
                testing::ElementsAre(Mentions(
                    "ScreenSpaceOutline.outlineWidth=14:", "ScreenSpaceOutline.m_OutlineWidth",
                    "14", "outside", "[1, 10]")));
    EXPECT_EQ(text, ReadText(file));
}

TEST(LimnSet, UndoesTheLastChangeAndBringsItBack)
{
    const TemporaryFolder folder;
    setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
    const std::string text = "Bloom: {intensity: 1} # mine\n";
    const auto file = folder.Write("a.profile.yaml", text);
    const CommandRun nothing = RunCommand({"set", file.string(), "--undo"});
    EXPECT_EQ(1, nothing.exitCode);
    EXPECT_THAT(nothing.err, testing::HasSubstr("no change of this file"));

    ASSERT_EQ(0, RunCommand({"set", file.string(), "Bloom.intensity=2"}).exitCode);
    const std::string changed = ReadText(file);
    EXPECT_EQ(0, RunCommand({"set", file.string(), "--undo"}).exitCode);
    EXPECT_EQ(text, ReadText(file));
    EXPECT_EQ(0, RunCommand({"set", file.string(), "--undo"}).exitCode);
    EXPECT_EQ(changed, ReadText(file));

    const std::string other = "Bloom: {intensity: 3}\n";
    folder.Write("a.profile.yaml", other);
    const CommandRun stale = RunCommand({"set", file.string(), "--undo"});
    EXPECT_EQ(1, stale.exitCode);
    EXPECT_THAT(stale.err, testing::HasSubstr("changed since"));
    EXPECT_EQ(other, ReadText(file));
    unsetenv("XDG_CACHE_HOME");
}

TEST(LimnSet, OfAMissingFileIsBadInputAndOfAWrongFormWrongUsage)
{
    EXPECT_EQ(1, RunCommand({"set", "/nowhere.yaml", "A.b=1"}).exitCode);
    EXPECT_EQ(2, RunCommand({"set", "/nowhere.yaml", "nonsense"}).exitCode);
    EXPECT_EQ(2, RunCommand({"set", "/nowhere.yaml"}).exitCode);
}

TEST(LimnSchema, OfProfilesHoldsRangeDefaultAndBothSpellings)
{
    const CommandRun run = RunCommand({"schema", "profile"});
    ASSERT_EQ(0, run.exitCode) << run.err;
    const auto schema = nlohmann::json::parse(run.out);
    EXPECT_EQ("https://json-schema.org/draft/2020-12/schema", schema["$schema"]);
    const auto& outline = schema["properties"]["ScreenSpaceOutline"]["properties"];
    const auto& width = outline["m_OutlineWidth"];
    EXPECT_EQ(1, width["minimum"]);
    EXPECT_EQ(10, width["maximum"]);
    EXPECT_EQ(3, width["default"]);
    EXPECT_NE("", width["description"]);
    EXPECT_EQ(width, outline["outlineWidth"]);
}

TEST(LimnSchema, OfScenesHoldsTheFeaturesSettings)
{
    const CommandRun run = RunCommand({"schema", "scene"});
    ASSERT_EQ(0, run.exitCode) << run.err;
    const auto schema = nlohmann::json::parse(run.out);
    const auto& feature = schema["properties"]["renderer"]["properties"]["features"]["items"];
    const auto& types = feature["properties"]["type"]["enum"];
    const auto type = std::find(types.begin(), types.end(), "ScreenSpaceOutlineRenderFeature");
    ASSERT_NE(types.end(), type);
    const auto index = static_cast<std::size_t>(type - types.begin());
    const auto& settings = feature["allOf"][index]["then"]["properties"];
    EXPECT_TRUE(settings.contains("m_LayerMask"));
    EXPECT_TRUE(settings.contains("layerMask"));
    EXPECT_THAT(settings["m_RenderPassEvent"]["description"].get<std::string>(),
                Mentions("Basic Settings:", "event"));
}

TEST(LimnSchema, OfMaterialsIsWhatAScenesMaterialsHave)
{
    const CommandRun run = RunCommand({"schema", "material"});
    ASSERT_EQ(0, run.exitCode) << run.err;
    const auto schema = nlohmann::json::parse(run.out);
    EXPECT_EQ("limn material", schema["title"]);
    EXPECT_EQ("A shader's name or a .shader file", schema["properties"]["shader"]["description"]);
    const auto scene = nlohmann::json::parse(RunCommand({"schema", "scene"}).out);
    const auto& inScenes = scene["properties"]["materials"]["additionalProperties"]["else"];
    EXPECT_EQ(inScenes["properties"], schema["properties"]);
    EXPECT_EQ(inScenes["additionalProperties"], schema["additionalProperties"]);
}

TEST(LimnSchema, OfAnotherKindIsWrongUsage)
{
    EXPECT_EQ(2, RunCommand({"schema", "shader"}).exitCode);
    EXPECT_EQ(2, RunCommand({"schema"}).exitCode);
}

} // namespace limn::test
