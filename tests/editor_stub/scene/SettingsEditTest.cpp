#include "Mentions.h"
#include "SceneFolder.h"
#include "commands/CommandRun.h"
#include "settings/FormsOfDescribe.h"

#include <gmock/gmock.h>
#include <limn/editor_stub/UnityRendererData.h>
#include <scene/SettingsEdit.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;

class SettingsEdit : public testing::Test
{
protected:
    SettingsEdit() { RegisterForms(folder.assets); }

    std::vector<ScalarChange> Set(const std::filesystem::path& path,
                                  const std::vector<std::string>& texts)
    {
        std::vector<ValueAssignment> edits;
        for (const std::string& text : texts)
        {
            edits.push_back(ValueAssignment::Parse(text, text));
        }
        return SetFeatureSettings(path, edits, folder.assets);
    }

    std::vector<std::string> ProblemsOf(const std::filesystem::path& path,
                                        const std::vector<std::string>& texts)
    {
        return Problems([&] { Set(path, texts); });
    }

    const std::string k_Scene = "# My scene\n"
                                "camera: {}\n"
                                "renderer:\n"
                                "  features:\n"
                                "    - type: FlatFeature # the first\n"
                                "      name: A.b\n"
                                "      m_Width: 1.50  # metres\n"
                                "      layers: 64\n"
                                "    - type: FlatFeature\n"
                                "      active: true\n"
                                "      settings: {m_Width: 2}\n";
    SceneFolder folder;
};

} // namespace

TEST_F(SettingsEdit, ChangesTheValueAndNoOtherByte)
{
    const auto path = folder.Write("a.scene.yaml", k_Scene);
    const std::vector<ScalarChange> changes =
        Set(path, {"A.b.width=2.5", "A.b.m_Layers=[Default, 3]"});
    std::string expected = k_Scene;
    expected.replace(expected.find("1.50"), 4, "2.5");
    expected.replace(expected.find("64"), 2, "[Default, 3]");
    EXPECT_EQ(expected, ReadText(path));
    ASSERT_EQ(2u, changes.size());
    EXPECT_EQ("A.b.m_Width", changes[0].subject);
    EXPECT_EQ("1.5", changes[0].before);
    EXPECT_EQ("2.5", changes[0].after);
    EXPECT_EQ("[6]", changes[1].before);
    EXPECT_EQ("[Default, 3]", changes[1].after);
}

TEST_F(SettingsEdit, ChangesOneNumberOfAVector)
{
    const auto path = folder.Write("a.scene.yaml", k_Scene);
    const std::vector<ScalarChange> changes = Set(path, {"A.b.tiling.y=4"});
    EXPECT_THAT(ReadText(path), testing::HasSubstr("m_Tiling: {x: 1, y: 4}\n"));
    EXPECT_EQ("{x: 1, y: 4}", changes.at(0).after);
    Set(path, {"A.b.tiling=[2, 3]"});
    EXPECT_THAT(ReadText(path), testing::HasSubstr("m_Tiling: {x: 2, y: 3}\n"));
}

TEST_F(SettingsEdit, ByAFeaturesTypeChangesAllOfThem)
{
    const auto path = folder.Write("a.scene.yaml", k_Scene);
    Set(path, {"FlatFeature.m_Width=7"});
    std::string expected = k_Scene;
    expected.replace(expected.find("m_Width: 2"), 10, "m_Width: 7");
    EXPECT_EQ(expected, ReadText(path)) << "the second has no name, so its type is its name";
}

TEST_F(SettingsEdit, SwitchesAFeature)
{
    const auto path = folder.Write("a.scene.yaml", k_Scene);
    const auto changes = Set(path, {"FlatFeature.active=false"});
    EXPECT_EQ("true", changes.at(0).before);
    EXPECT_EQ("false", changes.at(0).after);
    EXPECT_THAT(ReadText(path), testing::HasSubstr("active: false\n"));

    folder.Write("Assets/FlatFeature.cs.meta", "guid: aa\n");
    const auto asset = folder.Write("Assets/r.asset", AssetOfFeature(""));
    Set(asset, {"F.active=false"});
    EXPECT_THAT(ReadText(asset), testing::HasSubstr("m_Active: 0\n"));
}

TEST_F(SettingsEdit, LeavesTheFileIfOneOfTheValuesIsWrong)
{
    const auto path = folder.Write("a.scene.yaml", k_Scene);
    EXPECT_THAT(ProblemsOf(path, {"A.b.width=3", "A.b.width=11", "A.b.widht=1", "C.width=1"}),
                ElementsAre(Mentions("A.b.m_Width:", "11", "outside", "[0, 10]"),
                            Mentions("A.b:", "unknown setting", "'widht'", "'width'"),
                            Mentions("unknown feature", "'C'", "A.b, FlatFeature")));
    EXPECT_EQ(k_Scene, ReadText(path));
}

TEST_F(SettingsEdit, AddsWhatTheBlockOfTheFeatureLacks)
{
    const auto path = folder.Write("a.scene.yaml", k_Scene);
    const std::vector<ScalarChange> changes = Set(path, {"A.b.beside=true", "A.b.width+=1"});
    EXPECT_EQ("not set", changes.at(0).before);
    EXPECT_EQ("2.5", changes.at(1).after);
    std::string expected = k_Scene;
    expected.replace(expected.find("1.50"), 4, "2.5");
    const std::string last = "      layers: 64\n";
    expected.insert(expected.find(last) + last.size(), "      beside: true\n");
    EXPECT_EQ(expected, ReadText(path));
}

TEST_F(SettingsEdit, LeavesAFileWhereAnAliasRepeatsTheValue)
{
    const std::string text = "camera: {}\nrenderer: {features: [\n"
                             "{type: FlatFeature, name: A, m_Width: &w 1},\n"
                             "{type: FlatFeature, name: B, m_Width: *w}]}\n";
    const auto path = folder.Write("a.scene.yaml", text);
    EXPECT_THAT(ProblemsOf(path, {"A.m_Width=2"}),
                ElementsAre(Mentions("A.m_Width:", "alias", "by hand")));
    EXPECT_EQ(text, ReadText(path));
}

TEST_F(SettingsEdit, SaysWhereAVolumesParametersAre)
{
    const auto path = folder.Write("a.scene.yaml", "camera: {}\n");
    EXPECT_THAT(ProblemsOf(path, {"ScreenSpaceOutline.m_OutlineWidth=4", "A.b=1"}),
                ElementsAre(Mentions("'ScreenSpaceOutline'", "volume component", "not a feature",
                                     "profile"),
                            Mentions("unknown feature", "'A'", "no features")));
}

TEST_F(SettingsEdit, NamesTheFileThatHasTheFeatures)
{
    for (const char* renderer : {"r.asset", "{rendererData: r.asset}"})
    {
        const auto path =
            folder.Write("a.scene.yaml", "camera: {}\nrenderer: " + std::string(renderer) + "\n");
        EXPECT_THAT(ProblemsOf(path, {"A.m_Width=2"}),
                    ElementsAre(Mentions("renderer:", "'r.asset'", "in that file")));
    }
}

TEST_F(SettingsEdit, IsWhatTheVerbSetDoes)
{
    const TemporaryFolder other;
    const auto path = other.Write(
        "a.scene.yaml", "camera: {}\nrenderer: {features: [{type: RenderObjects, name: R,\n"
                        "  stencilSettings: {stencilReference: 1}, Event: 450}]}\n");
    const CommandRun run = RunCommand({"set", path.string(), "R.stencilSettings.stencilReference=2",
                                       "R.Event=AfterRenderingOpaques"});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_EQ("R.stencilSettings.stencilReference: 1 → 2\n"
              "R.Event: BeforeRenderingTransparents → AfterRenderingOpaques\n",
              run.out);
    EXPECT_EQ("camera: {}\nrenderer: {features: [{type: RenderObjects, name: R,\n"
              "  stencilSettings: {stencilReference: 2}, Event: AfterRenderingOpaques}]}\n",
              ReadText(path));
}

} // namespace limn::test
