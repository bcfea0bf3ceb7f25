#include "Mentions.h"
#include "SceneFolder.h"
#include "commands/CommandRun.h"
#include "settings/FormsOfDescribe.h"

#include <fstream>
#include <gmock/gmock.h>
#include <limn/editor_stub/Overrides.h>
#include <limn/editor_stub/UnityRendererData.h>
#include <scene/SettingsEdit.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;

/// A folder with a feature `F` of a class whose settings lie in a class of C#, in each form of
/// file.
class SettingsOf : public testing::TestWithParam<const char*>
{
protected:
    SettingsOf()
    {
        RegisterForms(folder.assets);
        folder.Write("Assets/" + type + ".cs.meta", "guid: aa\n");
    }

    static const DescribedValues& ValuesOf(const RendererAsset& renderer)
    {
        return dynamic_cast<const DescribedFeature&>(*renderer.features.at(0)).values;
    }

    DescribedValues OfAsset(const std::string& lines)
    {
        const UnityRendererDataLoadResult result = LoadUnityRendererData(
            folder.Write("Assets/r.asset", AssetOfFeature(lines)), folder.assets);
        notes = Texts(result.notes);
        return ValuesOf(result.renderer);
    }

    /// A scene with these keys of the feature.
    std::string Scene(const std::string& keys) const
    {
        return "camera: {}\nlayers: {6: Glass}\nrenderer: {features: [{type: " + type +
               ", name: F, " + keys + "}]}\n";
    }

    const std::string type = GetParam();
    SceneFolder folder;
    std::vector<std::string> notes;
};

void Expect(const DescribedValues& values)
{
    EXPECT_TRUE(values.beside);
    EXPECT_EQ(4.0f, values.width);
    EXPECT_EQ(LayerMask(64), values.layers);
}

/// What `--set` and `limn set` say of all three settings, with the groups that C# has.
const std::vector<std::string> k_Assignments{"F.beside=true", "F.settings.m_Width=4",
                                             "F.settings.filter.m_Layers=[6]"};

} // namespace

TEST_P(SettingsOf, AnAssetAreReadBesideAndInsideTheirClasses)
{
    Expect(OfAsset("  beside: 1\n"
                   "  settings:\n"
                   "    m_Width: 4\n"
                   "    filter:\n"
                   "      m_Layers: {serializedVersion: 2, m_Bits: 64}\n"));
    EXPECT_THAT(notes, ElementsAre());
}

TEST_P(SettingsOf, ASceneAreReadBesideAndInsideTheirClasses)
{
    const SceneAsset asset =
        folder.Load(Scene("beside: true, settings: {width: 4, filter: {m_Layers: [Glass]}}"));
    Expect(ValuesOf(asset.renderer));
}

TEST_P(SettingsOf, TheCommandLineHaveTheSamePaths)
{
    SceneAsset asset = folder.Load(Scene("active: true"));
    ApplyOverrides(asset, k_Assignments, folder.assets);
    Expect(ValuesOf(asset.renderer));
}

TEST_P(SettingsOf, AFileAreChangedByTheSamePaths)
{
    std::vector<ValueAssignment> edits;
    for (const std::string& text : k_Assignments)
    {
        edits.push_back(ValueAssignment::Parse(text, text));
    }
    const auto scene = folder.Write(
        "e.scene.yaml", Scene("beside: false, settings: {width: 1, filter: {m_Layers: []}}"));
    SetFeatureSettings(scene, edits, folder.assets);
    Expect(ValuesOf(LoadScene(scene, folder.assets).renderer));

    const std::string lines = "  beside: 0\n"
                              "  settings:\n"
                              "    m_Width: 1\n"
                              "    filter:\n"
                              "      m_Layers: {serializedVersion: 2, m_Bits: 0}\n";
    const auto asset = folder.Write("Assets/e.asset", AssetOfFeature(lines));
    SetFeatureSettings(asset, edits, folder.assets);
    EXPECT_EQ(AssetOfFeature("  beside: 1\n"
                             "  settings:\n"
                             "    m_Width: 4\n"
                             "    filter:\n"
                             "      m_Layers: {serializedVersion: 2, m_Bits: 64}\n"),
              ReadText(asset));
}

TEST_P(SettingsOf, AnAssetThatTheFeatureDoesNotHaveAreNotedEachWithItsLine)
{
    OfAsset("  shader: {fileID: 4800000, guid: bb, type: 3}\n"
            "  settings:\n"
            "    m_Width: 4\n"
            "    m_Old: {x: 1, y: 2}\n"
            "    filter:\n"
            "      m_Layers: {serializedVersion: 2, m_Bits: 64}\n"
            "      queue: 3\n");
    EXPECT_THAT(notes, ElementsAre(Mentions("9:3: F.shader:", "left out", type, "no such"),
                                   Mentions("12:5: F.settings.m_Old:", "left out", type, "no such"),
                                   Mentions("15:7: F.settings.filter.queue:", "left out", type,
                                            "no such")));
}

INSTANTIATE_TEST_SUITE_P(EachForm, SettingsOf, testing::Values("GroupedFeature", "FlatFeature"));

namespace
{

/// Whatever Describe looks like, by type.
class SettingsErrors : public testing::Test
{
protected:
    SettingsErrors() { RegisterForms(folder.assets); }

    std::vector<std::string> ProblemsOf(const std::string& type, const std::string& keys)
    {
        return folder.ProblemsOf("camera: {}\nrenderer: {features: [\n{type: " + type + ", " +
                                 keys + "}]}\n");
    }

    std::vector<std::string> ProblemsOfSet(const std::string& type, const std::string& text)
    {
        SceneAsset asset =
            folder.LoadWithCamera("renderer: {features: [{type: " + type + ", name: F}]}\n");
        return Problems([&] { ApplyOverrides(asset, std::vector{text}, folder.assets); });
    }

    SceneFolder folder;
};

} // namespace

TEST_F(SettingsErrors, NameTheNearestKeyAndThePathOfOneThatStandsElsewhere)
{
    EXPECT_THAT(ProblemsOf("GroupedFeature", "m_Width: 4"),
                ElementsAre(Mentions("3:24: renderer.features[0]:", "unknown key", "'m_Width'",
                                     "'settings.m_Width'")));
    EXPECT_THAT(ProblemsOf("GroupedFeature", "settings: {widht: 4, beside: true}"),
                ElementsAre(Mentions("3:35: renderer.features[0].settings:", "unknown key",
                                     "'widht'", "'width'"),
                            Mentions("3:45: renderer.features[0].settings:", "unknown key",
                                     "'beside'", "outside", "groups")));
    EXPECT_THAT(ProblemsOf("FlatFeature", "settings: {width: 4, layrs: 1}"),
                ElementsAre(Mentions("3:42: renderer.features[0].settings:", "unknown key",
                                     "'layrs'", "'layers'")));
    EXPECT_THAT(ProblemsOf("FlatFeature", "setings: {wdth: 4}"),
                ElementsAre(Mentions("3:21: renderer.features[0]:", "unknown key", "'setings'",
                                     "type, name, active, beside, width, layers")));
}

TEST_F(SettingsErrors, OfTheCommandLineNameThePath)
{
    EXPECT_THAT(ProblemsOfSet("GroupedFeature", "F.width=4"),
                ElementsAre(Mentions("F:", "unknown setting", "'width'", "'settings.m_Width'")));
    EXPECT_THAT(
        ProblemsOfSet("GroupedFeature", "F.settings.filter.m_Layrs=4"),
        ElementsAre(Mentions("F.settings.filter:", "unknown setting", "'m_Layrs'", "'m_Layers'")));
    EXPECT_THAT(ProblemsOfSet("GroupedFeature", "F.settings.m_Width=11"),
                ElementsAre(Mentions("F.settings.m_Width:", "11", "outside", "[0, 10]")));
    EXPECT_THAT(ProblemsOfSet("FlatFeature", "F.settings.m_Width=11"),
                ElementsAre(Mentions("F.settings.m_Width:", "11", "outside", "[0, 10]")));
}

TEST_F(SettingsErrors, RefuseASettingBesideAndInsideItsClass)
{
    EXPECT_THAT(ProblemsOf("FlatFeature", "m_Width: 4, settings: {width: 5}"),
                ElementsAre(Mentions("3:44: renderer.features[0].settings.m_Width:",
                                     "renderer.features[0].m_Width", "3:21", "same key")));
}

TEST_F(SettingsErrors, OfAnAssetAreANoteWhereTwoClassesHaveTheName)
{
    folder.Write("Assets/FlatFeature.cs.meta", "guid: aa\n");
    const auto path = folder.Write("Assets/r.asset", AssetOfFeature("  m_Width: 4\n"
                                                                    "  settings: {m_Width: 5}\n"));
    const UnityRendererDataLoadResult result = LoadUnityRendererData(path, folder.assets);
    EXPECT_EQ(4.0f,
              dynamic_cast<const DescribedFeature&>(*result.renderer.features.at(0)).values.width);
    EXPECT_THAT(Texts(result.notes),
                ElementsAre(Mentions("10:14: F.settings.m_Width:", "left out", "FlatFeature",
                                     "F.m_Width", "9:3", "Describe")));
}

TEST_F(SettingsErrors, DoNotTakeAVectorOrAReferenceForAClass)
{
    class XFeature final : public DescribedFeature
    {
    public:
        void Describe(Inspector& inspector) override
        {
            inspector.Field("x", values.width, "");
            inspector.Field("type", values.beside, "");
        }
    };
    folder.assets.features().Register<XFeature>("XFeature");
    folder.Write("Assets/XFeature.cs.meta", "guid: aa\n");
    const auto path = folder.Write("Assets/r.asset",
                                   AssetOfFeature("  offset: {x: 5, y: 6}\n"
                                                  "  shader: {fileID: 1, guid: bb, type: 3}\n"));
    const UnityRendererDataLoadResult result = LoadUnityRendererData(path, folder.assets);
    EXPECT_EQ(1.0f,
              dynamic_cast<const DescribedFeature&>(*result.renderer.features.at(0)).values.width);
    EXPECT_THAT(Texts(result.notes),
                ElementsAre(Mentions("9:3: F.offset:", "left out", "XFeature", "no such"),
                            Mentions("10:3: F.shader:", "left out", "XFeature", "no such")));
}

namespace
{

class LayersFeature final : public DescribedFeature
{
public:
    RenderingLayerMask m_RenderingLayerMask;
    std::uint32_t m_Bits = 0;
    std::uint32_t m_Few = 0;

    void Describe(Inspector& inspector) override
    {
        inspector.Field("m_RenderingLayerMask", m_RenderingLayerMask, "");
        inspector.Field("m_Bits", m_Bits, "");
        inspector.Field("m_Few", m_Few, {0, 3}, "");
    }
};

} // namespace

TEST(SettingsOfRenderingLayers, AreReadInUnitysForms)
{
    SceneFolder folder;
    folder.assets.features().Register<LayersFeature>("LayersFeature");
    folder.Write("Assets/LayersFeature.cs.meta", "guid: aa\n");
    for (const char* mask : {"257", "{serializedVersion: 0, m_Bits: 257}"})
    {
        const auto path = folder.Write(
            "Assets/r.asset", AssetOfFeature("  m_RenderingLayerMask: " + std::string(mask) +
                                             "\n  m_Bits: 4294967295\n"));
        const UnityRendererDataLoadResult result = LoadUnityRendererData(path, folder.assets);
        const auto& feature = dynamic_cast<const LayersFeature&>(*result.renderer.features.at(0));
        EXPECT_EQ(RenderingLayerMask(257), feature.m_RenderingLayerMask) << mask;
        EXPECT_EQ(4294967295u, feature.m_Bits);
    }
}

TEST(SettingsOfRenderingLayers, GoByTheNamesOfTheScene)
{
    SceneFolder folder;
    folder.assets.features().Register<LayersFeature>("LayersFeature");
    const std::string head = "camera: {}\nlayers: {6: Glass}\nrenderingLayers: {8: Outlined}\n"
                             "renderer: {features: [{type: LayersFeature, ";
    const SceneAsset asset = folder.Load(head + "m_RenderingLayerMask: [Outlined, 0]}]}\n");
    const auto& feature = dynamic_cast<const LayersFeature&>(*asset.renderer.features.at(0));
    EXPECT_EQ(RenderingLayerMask(257), feature.m_RenderingLayerMask);
    EXPECT_THAT(folder.ProblemsOf(head + "m_RenderingLayerMask: Glass, m_Bits: -1, m_Few: 4}]}\n"),
                ElementsAre("4:67: renderer.features[0].m_RenderingLayerMask: unknown rendering "
                            "layer 'Glass' (known: Default, Outlined)",
                            "4:82: renderer.features[0].m_Bits: -1 is outside [0, 4294967295]",
                            "4:93: renderer.features[0].m_Few: 4 is outside [0, 3]"));
}

} // namespace limn::test
