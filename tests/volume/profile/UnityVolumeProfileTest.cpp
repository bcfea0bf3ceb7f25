#include "Mentions.h"
#include "Paths.h"
#include "Problems.h"
#include "TestComponents.h"

#include "TemporaryFolder.h"
#include <gmock/gmock.h>
#include <limn/volume/VolumeProfileLoader.h>

namespace limn
{

namespace
{

using test::Mentions;
using test::Problems;
using test::ScreenSpaceOutline;
using test::Texts;
using testing::ElementsAre;
using testing::IsEmpty;

const std::string k_Header = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";

/// A profile object with references to the given ids; 6 lines.
std::string Profile(const std::string& references)
{
    return "--- !u!114 &11400000\nMonoBehaviour:\n  m_Name: P\n  components:" + references + "\n";
}

class LoadUnityProfile : public ::testing::Test
{
protected:
    VolumeProfileLoadResult Load(const std::string& body) const
    {
        return LoadVolumeProfile(m_Folder.Write("P.asset", k_Header + body), m_Registry);
    }

    std::vector<std::string> ProblemsIn(const std::string& body) const
    {
        return Problems([&] { Load(body); });
    }

    test::TemporaryFolder m_Folder;
    test::TestRegistry m_Registry;
};

TEST_F(LoadUnityProfile, ReadsAnAssetAsUnitySavesIt)
{
    const VolumeProfileLoadResult result = LoadVolumeProfile(
        test::SourcePath("tests/volume/data/SampleSceneProfile.asset"), m_Registry);
    const auto* outline = result.profile->TryGet<ScreenSpaceOutline>();
    ASSERT_NE(outline, nullptr);
    EXPECT_EQ(result.profile->name, "SampleSceneProfile");
    EXPECT_TRUE(outline->active);
    EXPECT_TRUE(outline->m_Enable.value());
    EXPECT_TRUE(outline->m_Enable.overrideState());
    EXPECT_EQ(outline->m_OutlineColor.value(), (Color{0.0f, 0.49606514f, 1.0f, 1.0f}));
    EXPECT_TRUE(outline->m_OutlineColor.overrideState());
    EXPECT_EQ(outline->m_OutlineWidth.value(), 10.0f);
    EXPECT_TRUE(outline->m_OutlineWidth.overrideState());
    EXPECT_THAT(result.notes, IsEmpty()) << "URP's Bloom overrides nothing there";
}

TEST_F(LoadUnityProfile, IsChosenByContentNotByName)
{
    const auto path = m_Folder.Write("odd.profile.yaml", k_Header + Profile(" []"));
    EXPECT_EQ(LoadVolumeProfile(path, m_Registry).profile->name, "P");
    const auto own = m_Folder.Write("odd.asset", "TestVolume: {param: 5}\n");
    EXPECT_EQ(LoadVolumeProfile(own, m_Registry).profile->TryGet<test::TestVolume>()->param.value(),
              5.0f);
}

TEST_F(LoadUnityProfile, KeepsTheValueOfAParameterThatIsNotOverridden)
{
    const auto result = Load("--- !u!114 &7\n"
                             "MonoBehaviour:\n"
                             "  m_Name: TestVolume\n"
                             "  active: 0\n"
                             "  param:\n"
                             "    m_OverrideState: 0\n"
                             "    m_Value: 5\n" +
                             Profile("\n  - {fileID: 7}"));
    const auto* component = result.profile->TryGet<test::TestVolume>();
    ASSERT_NE(component, nullptr);
    EXPECT_FALSE(component->active);
    EXPECT_FALSE(component->param.overrideState());
    EXPECT_EQ(component->param.value(), 5.0f);
}

TEST_F(LoadUnityProfile, TakesTheOrderOfTheReferencesAndOnlyThose)
{
    const auto result = Load("--- !u!114 &1\nMonoBehaviour:\n  m_Name: TestVolume\n"
                             "--- !u!114 &2\nMonoBehaviour:\n  m_Name: Mixed\n"
                             "--- !u!114 &3\nMonoBehaviour:\n  m_Name: ScreenSpaceOutline\n" +
                             Profile("\n  - {fileID: 2}\n  - {fileID: 1}"));
    ASSERT_EQ(result.profile->components().size(), 2u);
    EXPECT_EQ(result.profile->components()[0].get(), result.profile->TryGet<test::Mixed>());
    EXPECT_FALSE(result.profile->Has<ScreenSpaceOutline>());
}

TEST_F(LoadUnityProfile, NotesParametersAndReferencesThatItDoesNotKnow)
{
    const auto result = Load("--- !u!114 &7\n"
                             "MonoBehaviour:\n"
                             "  m_Name: TestVolume\n"
                             "  m_Script: {fileID: 11500000}\n"
                             "  extra:\n"
                             "    m_OverrideState: 1\n"
                             "    m_Value: {fileID: 0}\n" +
                             Profile("\n  - {fileID: 0}\n  - {fileID: 7}\n  - {fileID: 8}"));
    EXPECT_THAT(Texts(result.notes),
                ElementsAre(Mentions("7:3: TestVolume.extra", "left out", "parameter"),
                            Mentions("14:5: components", "left out", "object 0"),
                            Mentions("16:5: components", "left out", "object 8")));
    EXPECT_TRUE(result.profile->Has<test::TestVolume>());
}

TEST_F(LoadUnityProfile, NotesOnceAComponentWhatUrpHasAndLimnDoesNot)
{
    struct Tonemapping : VolumeComponent
    {
        IntParameter mode{this, "mode", 0};
    };
    m_Registry.Register<Tonemapping>("Tonemapping");
    const auto parameter = [](const std::string& name, const char* state)
    {
        return "  " + name + ":\n    m_OverrideState: " + state + "\n    m_Value: 1\n";
    };
    const std::string head = "MonoBehaviour:\n  active: 1\n  m_Name: ";
    const auto result =
        Load("--- !u!114 &1\n" + head + "Tonemapping\n  m_AdvancedMode: 0\n" +
             parameter("mode", "1") + parameter("acesPreset", "0") + parameter("minNits", "1") +
             parameter("paperWhite", "1") + parameter("papperWhite", "0") + //
             "--- !u!114 &2\n" + head + "FilmGrain\n" + parameter("intensity", "1") +
             "--- !u!114 &3\n" + head + "MotionBlur\n" + parameter("intensity", "0") +
             Profile("\n  - {fileID: 1}\n  - {fileID: 2}\n  - {fileID: 3}"));
    EXPECT_THAT(Texts(result.notes),
                ElementsAre(Mentions("4:1: Tonemapping", "URP", "minNits, paperWhite"),
                            Mentions("20:3: Tonemapping.papperWhite", "left out", "parameter"),
                            Mentions("24:1: FilmGrain", "left out", "URP")));
    EXPECT_EQ(1, result.profile->TryGet<Tonemapping>()->mode.value());
}

TEST_F(LoadUnityProfile, RefusesBadValuesOfKnownParameters)
{
    EXPECT_THAT(ProblemsIn("--- !u!114 &7\n"
                           "MonoBehaviour:\n"
                           "  m_Name: ScreenSpaceOutline\n"
                           "  active: 3\n"
                           "  unknown: 1\n"
                           "  m_Enable: 1\n"
                           "  m_OutlineWidth:\n"
                           "    m_OverrideState: 2\n"
                           "    m_Value: 14\n"
                           "  m_OutlineColor:\n"
                           "    m_OverrideState: 1\n"
                           "    m_Value: {r: 0, g: 0, a: 1}\n" +
                           Profile("\n  - {fileID: 7}")),
                ElementsAre(Mentions("6:11: ScreenSpaceOutline.active", "'3'", "true or false"),
                            Mentions("8:3: ScreenSpaceOutline.m_Enable", "m_OverrideState",
                                     "m_Value", "missing"),
                            Mentions("10:22: ScreenSpaceOutline.m_OutlineWidth.m_OverrideState",
                                     "'2'", "true or false"),
                            "11:14: ScreenSpaceOutline.m_OutlineWidth: 14 is outside [1, 10]",
                            "14:14: ScreenSpaceOutline.m_OutlineColor: key 'b' is missing"));
}

TEST_F(LoadUnityProfile, RefusesTwoComponentsOfOneType)
{
    EXPECT_THAT(
        ProblemsIn("--- !u!114 &1\nMonoBehaviour:\n  m_Name: Mixed\n"
                   "--- !u!114 &2\nMonoBehaviour:\n  m_Name: Mixed\n" +
                   Profile("\n  - {fileID: 1}\n  - {fileID: 2}\n  - Mixed")),
        ElementsAre(Mentions("7:1: Mixed", "two components", "type"),
                    Mentions("15:5: components", "'Mixed'", "reference", "{fileID: 11400000}")));
}

TEST_F(LoadUnityProfile, RefusesAnAssetWithoutAProfile)
{
    const auto message = Mentions("no volume profile", "MonoBehaviour", "'components'");
    EXPECT_THAT(ProblemsIn("--- !u!78 &1\nTagManager:\n  tags: []\n"), ElementsAre(message));
    EXPECT_THAT(ProblemsIn(Profile(" {a: 1}")), ElementsAre(message));
    EXPECT_THAT(ProblemsIn(Profile(" text")), ElementsAre(message));
}

} // namespace

} // namespace limn
