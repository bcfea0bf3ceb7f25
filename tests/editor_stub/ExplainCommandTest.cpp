#include "CommandRun.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limn::test
{

namespace
{

using testing::HasSubstr;

constexpr const char* k_Scene = "camera: {position: [0, 0, -5]}\n"
                                "size: [64, 64]\n"
                                "volumes:\n"
                                "  - {name: Placement, profile: p.profile.yaml}\n"
                                "  - name: Corner\n"
                                "    profile: q.profile.yaml\n"
                                "    isGlobal: false\n"
                                "    priority: 1\n"
                                "    weight: 0.5\n"
                                "    blendDistance: 4\n"
                                "    position: [0, 0, -2]\n"
                                "    colliders: [{type: sphere, radius: 1}]\n"
                                "objects:\n"
                                "  - {name: Seen, mesh: Cube}\n"
                                "  - {name: Behind, mesh: Cube, position: [0, 0, -50]}\n"
                                "  - {name: Off, mesh: Cube, active: false}\n";

class ExplainCommand : public testing::Test
{
protected:
    CommandRun Explain(const std::vector<std::string>& more = {},
                       const std::string& scene = k_Scene) const
    {
        m_Folder.Write("p.profile.yaml", "ScreenSpaceOutline: {m_OutlineWidth: 4}\n");
        m_Folder.Write("q.profile.yaml", "ScreenSpaceOutline: {m_OutlineWidth: 8}\n");
        const std::filesystem::path path = m_Folder.Write("s.scene.yaml", scene);
        std::vector<std::string> args{"explain", path.string()};
        args.insert(args.end(), more.begin(), more.end());
        return RunCommand(args);
    }

    TemporaryFolder m_Folder;
};

TEST_F(ExplainCommand, TellsWhereEveryVolumeValueComesFrom)
{
    const CommandRun run = Explain();
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_THAT(run.out,
                HasSubstr("volume values:\n"
                          "  ScreenSpaceOutline.m_OutlineWidth ← Placement (factor 1, weight 1, "
                          "global) → 4\n"
                          "  ScreenSpaceOutline.m_OutlineWidth ← Corner (factor 0.375, weight 0.5, "
                          "distance 2 m) → 5.5\n"));
}

TEST_F(ExplainCommand, TellsWhyEachObjectIsDrawnOrNot)
{
    const CommandRun run = Explain();
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_THAT(run.out, HasSubstr("  Seen\n"));
    EXPECT_THAT(run.out, HasSubstr("Default-Material: drawn\n"));
    EXPECT_THAT(run.out, HasSubstr("Default-Material: left out, render queue\n"));
    EXPECT_THAT(run.out, HasSubstr("  Behind: not drawn, outside the camera's frustum\n"));
    EXPECT_THAT(run.out, HasSubstr("  Off: not drawn, inactive\n"));
}

TEST_F(ExplainCommand, ShowsOnlyTheObjectAskedFor)
{
    const CommandRun run = Explain({"--object", "Off"});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_THAT(run.out, HasSubstr("objects:\n  Off: not drawn, inactive\n"));
    EXPECT_THAT(run.out, testing::Not(HasSubstr("Behind")));
}

TEST(ExplainSample, ShowsWhatHangsBelowTheObjectAskedFor)
{
    const CommandRun run = RunCommand(
        {"explain", LIMN_SOURCE_DIR "/samples/furniture/furniture.scene.yaml", "--object", "Sofa"});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Screen Space Outline, petrol: drawn\n"));
    EXPECT_THAT(run.out, testing::Not(HasSubstr("Slab")));
    EXPECT_THAT(run.out, testing::Not(HasSubstr("Screen Space Outline, oak: drawn\n")));
}

TEST_F(ExplainCommand, RefusesAnObjectThatIsNotThere)
{
    const CommandRun run = Explain({"--object", "Sen"});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_EQ("", run.out);
    EXPECT_THAT(run.err, HasSubstr("s.scene.yaml: error: unknown object with a mesh 'Sen'; did you "
                                   "mean 'Seen'?"));
}

TEST_F(ExplainCommand, GivesTheSameToProgramsAsJson)
{
    const CommandRun run = Explain({"--json"});
    ASSERT_EQ(0, run.exitCode) << run.err;
    const auto json = nlohmann::json::parse(run.out);
    ASSERT_EQ(1u, json.at("volumes").size());
    const auto& width = json.at("volumes")[0];
    EXPECT_EQ("m_OutlineWidth", width.at("parameter"));
    EXPECT_EQ("3", width.at("default"));
    EXPECT_EQ("5.5", width.at("value"));
    ASSERT_EQ(2u, width.at("steps").size());
    EXPECT_TRUE(width.at("steps")[0].at("distance").is_null());
    EXPECT_EQ(0.375, width.at("steps")[1].at("factor"));
    EXPECT_EQ(2.0, width.at("steps")[1].at("distance"));
    EXPECT_FALSE(json.at("passes").empty());
    EXPECT_FALSE(json.at("textures").empty());
    EXPECT_FALSE(json.at("variants").empty());
    EXPECT_EQ("Behind", json.at("objects")[1].at("name"));
    EXPECT_EQ("outside the camera's frustum", json.at("objects")[1].at("absence"));
}

TEST_F(ExplainCommand, NamesWhatIsWrongWithAShapeAndItsWeight)
{
    const CommandRun run = Explain(
        {}, "camera: {}\nvolumes:\n  - name: V\n    profile: p.profile.yaml\n    isGlobal: false\n"
            "    weight: .nan\n    colliders: [{type: spher}, {type: capsule, direction: w}]\n");
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err, HasSubstr("volume 'V'.weight"));
    EXPECT_THAT(run.err, HasSubstr("volume 'V'.colliders[0].type: unknown shape 'spher'; did you "
                                   "mean 'sphere'?"));
    EXPECT_THAT(run.err, HasSubstr("volume 'V'.colliders[1].direction: 'w' is no axis; x, y or z "
                                   "is expected"));
}

TEST_F(ExplainCommand, NeedsAScene)
{
    const CommandRun run = RunCommand({"explain"});
    EXPECT_EQ(2, run.exitCode);
    EXPECT_THAT(run.err, HasSubstr("scene is required"));
}

} // namespace

} // namespace limn::test
