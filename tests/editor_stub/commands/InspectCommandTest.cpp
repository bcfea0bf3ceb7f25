#include "Mentions.h"
#include "commands/CommandRun.h"
#include "explain/InspectReport.h"

#include <gmock/gmock.h>
#include <limn/volume/ValueParameters.h>
#include <nlohmann/json.hpp>

namespace limn::test
{

namespace
{

using testing::HasSubstr;

struct Filter : VolumeComponent
{
    LayerMaskParameter near{this, "m_Near", {}};
    LayerMaskParameter far{this, "m_Far", {}};
    LayerMaskParameter sky{this, "m_Sky", {}};
};

class Inspect : public testing::Test
{
protected:
    Inspect()
    {
        folder.Write("on.profile.yaml", "ScreenSpaceOutline: {m_OutlineWidth: 4}\n");
        folder.Write("s.scene.yaml", "camera: {}\n"
                                     "layers: {6: Furniture}\n"
                                     "renderer:\n"
                                     "  features:\n"
                                     "    - type: ScreenSpaceOutlineRenderFeature\n"
                                     "      name: Outline\n"
                                     "      m_LayerMask: [Furniture]\n"
                                     "volumes: [{name: Room, profile: on.profile.yaml}]\n");
    }

    CommandRun Run(const std::string& name, const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> args{"inspect", (folder / name).string()};
        args.insert(args.end(), more.begin(), more.end());
        return RunCommand(args);
    }

    TemporaryFolder folder;
};

nlohmann::json Named(const nlohmann::json& list, const std::string& name)
{
    for (const auto& item : list)
    {
        if (item["name"] == name)
        {
            return item;
        }
    }
    return {};
}

} // namespace

TEST_F(Inspect, TellsWhichParametersOfAProfileAreSet)
{
    const CommandRun run = Run("on.profile.yaml", {"--json"});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_EQ("", run.err);
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ("profile", json["kind"]);
    const auto& component = json["components"][0];
    EXPECT_EQ("ScreenSpaceOutline", component["type"]);
    const auto width = Named(component["parameters"], "m_OutlineWidth");
    EXPECT_EQ(4, width["value"]);
    EXPECT_EQ(3, width["default"]);
    EXPECT_EQ(nlohmann::json({1.0, 10.0}), width["range"]);
    EXPECT_EQ(true, width["isSet"]);
    const auto enable = Named(component["parameters"], "m_Enable");
    EXPECT_EQ(false, enable["value"]);
    EXPECT_EQ(false, enable["isSet"]);
}

TEST_F(Inspect, PrintsAProfileAsColumns)
{
    const CommandRun run = Run("on.profile.yaml");
    EXPECT_THAT(run.out, testing::StartsWith("  ScreenSpaceOutline\n    m_Enable "));
    EXPECT_THAT(run.out, testing::ContainsRegex("m_OutlineWidth +4 +default 3 +.1, 10. .*set"));
}

TEST_F(Inspect, ShowsAScenesVolumesAndFeatures)
{
    const auto json = nlohmann::json::parse(Run("s.scene.yaml", {"--json"}).out);
    EXPECT_EQ("scene", json["kind"]);
    EXPECT_EQ("Room", json["volumes"][0]["name"]);
    const auto& feature = json["features"][0];
    EXPECT_EQ("Outline", feature["name"]);
    EXPECT_EQ("ScreenSpaceOutlineRenderFeature", feature["type"]);
    const auto mask = Named(feature["settings"], "m_LayerMask");
    EXPECT_EQ("[Furniture]", mask["value"]);
    EXPECT_EQ(true, mask["isSet"]);

    const std::string text = Run("s.scene.yaml").out;
    EXPECT_THAT(text, HasSubstr("volume 'Room': global, priority 0, weight 1, profile '"));
    EXPECT_THAT(text, HasSubstr("feature 'Outline': ScreenSpaceOutlineRenderFeature\n"));
}

TEST_F(Inspect, ShowsTheLayersOfASceneAsAProfileHasThem)
{
    const auto path = folder.Write("f.profile.yaml", "Filter:\n"
                                                     "  m_Near: [Default, Furniture]\n"
                                                     "  far: Walls\n"
                                                     "  sky: [Water]\n");
    AssetContext assets;
    assets.volumeComponents().Register<Filter>("Filter");
    std::ostringstream out;
    std::ostringstream err;
    Console console(out, err);
    const std::vector<InspectedGroup> groups =
        InspectProfileFile(path, LoadYamlFile(path), assets, console);
    ASSERT_EQ(1u, groups.size());
    EXPECT_EQ("[Default, Furniture]", groups[0].values[0].value);
    EXPECT_EQ("Walls", groups[0].values[1].value);
    EXPECT_EQ("16", groups[0].values[2].value); // Water is layer 4 everywhere
    EXPECT_THAT(LinesOf(err.str()),
                testing::ElementsAre(Mentions(path.string() + ":2:11:", "note", "Filter.m_Near",
                                              "only a scene", "'Furniture'"),
                                     Mentions(path.string() + ":3:8:", "note", "Filter.m_Far",
                                              "only a scene", "'Walls'")));
}

TEST_F(Inspect, ListsTheErrorsOfAWrongFile)
{
    folder.Write("bad.profile.yaml", "ScreenSpaceOutline: {m_OutlineWidth: 14}\n");
    const CommandRun run = Run("bad.profile.yaml");
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(LinesOf(run.err),
                testing::ElementsAre(Mentions((folder / "bad.profile.yaml").string() + ":1:38:",
                                              "ScreenSpaceOutline.m_OutlineWidth", "14", "outside",
                                              "[1, 10]")));
    EXPECT_EQ("", run.out);
}

TEST_F(Inspect, WithoutAFileIsWrongUsage)
{
    EXPECT_EQ(2, RunCommand({"inspect"}).exitCode);
}

TEST_F(Inspect, AMissingFileIsNamed)
{
    const CommandRun run = Run("missing.profile.yaml");
    EXPECT_EQ(1, run.exitCode);
    EXPECT_EQ((folder / "missing.profile.yaml").string() + ": error: there is no such file\n",
              run.err);
}

TEST(InspectName, ShowsTheDefaultsOfAComponentAndOfTheFeatureOfItsName)
{
    const CommandRun run = RunCommand({"inspect", "StrokeOutline", "--json"});
    ASSERT_EQ(0, run.exitCode) << run.err;
    const auto json = nlohmann::json::parse(run.out);
    const auto width = Named(json["components"].at(0)["parameters"], "m_OutlineWidth");
    EXPECT_EQ(width["default"], width["value"]);
    EXPECT_EQ("pixels", width["unit"]);
    EXPECT_EQ("StrokeOutlineRendererFeature", json["features"].at(0)["type"]);
    EXPECT_THAT(Named(json["features"].at(0)["settings"], "m_LayerMask")["value"], "Everything");
}

TEST(InspectName, ShowsThePropertiesOfAShader)
{
    const CommandRun run = RunCommand({"inspect", "Universal Render Pipeline/Lit"});
    ASSERT_EQ(0, run.exitCode) << run.err;
    EXPECT_THAT(run.out, testing::ContainsRegex("_Smoothness +0.5 +Range\\(0, 1\\)"));
}

TEST(InspectName, OffersTheNearestName)
{
    for (const auto& [wrong, right] :
         {std::pair("StrokOutline", "StrokeOutline"),
          std::pair("Universal Render Pipeline/Lid", "Universal Render Pipeline/Lit")})
    {
        const CommandRun run = RunCommand({"inspect", wrong});
        EXPECT_EQ(1, run.exitCode);
        EXPECT_THAT(run.err, testing::HasSubstr("did you mean '" + std::string(right) + "'?"));
    }
}

TEST_F(Inspect, OffersTheNearestFileForAReference)
{
    folder.Write("t.scene.yaml",
                 "camera: {}\nvolumes: [{name: Room, profile: onn.profile.yaml}]\n");
    EXPECT_THAT(Run("t.scene.yaml").err,
                Mentions("t.scene.yaml:2:33:", "volume 'Room'.profile", "no file",
                         "'onn.profile.yaml'", "'on.profile.yaml'"));
}

TEST_F(Inspect, OffersTheNearestFile)
{
    const CommandRun run = Run("onn.profile.yaml");
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err,
                testing::HasSubstr("did you mean '" + (folder / "on.profile.yaml").string()));
}

/// Every short stem is near to every other, so only the rest of the name may differ.
TEST_F(Inspect, OffersAFileOfTheSameShortNameAndAnotherEnding)
{
    EXPECT_THAT(Run("on.profil.yaml").err, Mentions("did you mean", "on.profile.yaml"));
    EXPECT_THAT(Run("an.profile.yaml").err, testing::Not(testing::HasSubstr("did you mean")));
}

} // namespace limn::test
