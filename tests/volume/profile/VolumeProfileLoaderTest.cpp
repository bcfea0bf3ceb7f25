#include "Mentions.h"
#include "Problems.h"
#include "TestComponents.h"

#include "TemporaryFolder.h"
#include <core/ThrownMessage.h>
#include <gmock/gmock.h>
#include <limn/volume/VolumeProfileLoader.h>

namespace limn
{

namespace
{

using test::Mentions;
using test::Problems;
using test::ScreenSpaceOutline;
using testing::ElementsAre;
using testing::IsEmpty;

class LoadOwnProfile : public ::testing::Test
{
protected:
    VolumeProfileLoadResult Load(const std::string& text) const
    {
        return LoadVolumeProfile(m_Folder.Write("hero.profile.yaml", text), m_Registry);
    }

    std::vector<std::string> ProblemsIn(const std::string& text) const
    {
        return Problems([&] { Load(text); });
    }

    test::TemporaryFolder m_Folder;
    test::TestRegistry m_Registry;
};

TEST_F(LoadOwnProfile, OverridesWhatIsNamedAndNothingElse)
{
    const VolumeProfileLoadResult result = Load("# the hero's outline\n"
                                                "ScreenSpaceOutline:\n"
                                                "  m_Enable: true\n"
                                                "  m_OutlineWidth: 4\n");
    const auto* outline = result.profile->TryGet<ScreenSpaceOutline>();
    ASSERT_NE(outline, nullptr);
    EXPECT_TRUE(outline->active);
    EXPECT_TRUE(outline->m_Enable.value());
    EXPECT_TRUE(outline->m_Enable.overrideState());
    EXPECT_EQ(outline->m_OutlineWidth.value(), 4.0f);
    EXPECT_TRUE(outline->m_OutlineWidth.overrideState());
    EXPECT_FALSE(outline->m_OutlineColor.overrideState());
    EXPECT_EQ(outline->m_OutlineColor.value(), Color::white);
    EXPECT_EQ(result.profile->name, "hero");
    EXPECT_THAT(result.notes, IsEmpty());
}

TEST_F(LoadOwnProfile, NamesTheCauseOfCommonSyntaxErrors)
{
    const std::string component = "ScreenSpaceOutline:\n";
    EXPECT_THAT(ProblemsIn(component + "\tm_Enable: true\n"),
                ElementsAre(Mentions("2:1:", "YAML", "tab", "spaces")));
    EXPECT_THAT(ProblemsIn(component + "  m_Enable:true\n  m_OutlineWidth: 4\n"),
                ElementsAre(Mentions("2:11:", "YAML", "space", "missing", "':'")));
    EXPECT_THAT(ProblemsIn(component + "  m_Enable:true # on\n  m_OutlineWidth: 4\n"),
                ElementsAre(Mentions("2:11:", "space", "missing", "':'")));
    // Lines of letters alone, and the last one, have no cause of these.
    for (const char* text : {"ScreenSpaceOutline\n  m_OutlineWidth: 4\n", "a\nb: 1", "a:b\n c: 1"})
    {
        EXPECT_THAT(ProblemsIn(text), ElementsAre(testing::HasSubstr("this is not valid YAML: a")));
    }
    EXPECT_THAT(ProblemsIn(component + "  m_OutlineColor: {r: 1 g: 0, b: 0}\n"),
                ElementsAre(Mentions("2:24:", "YAML", "','", "missing")));
    EXPECT_THAT(
        ProblemsIn(component + "m_Enable: true\n"),
        ElementsAre(Mentions("2:1:", "'m_Enable'", "parameter of ScreenSpaceOutline", "spaces")));
}

TEST_F(LoadOwnProfile, NotesAColourThatLooksLikeBytes)
{
    const auto notesOf = [this](const std::string& color)
    {
        return Load("ScreenSpaceOutline: {m_OutlineColor: " + color + "}\n").notes.size();
    };
    EXPECT_EQ(1u, notesOf("{r: 255, g: 128, b: 0}"));
    EXPECT_EQ(1u, notesOf("[0, 0, 255]"));
    EXPECT_EQ(0u, notesOf("[1, 1, 1]"));
    EXPECT_EQ(0u, notesOf("[47.9, 2, 0]")) << "light beyond white";
    EXPECT_EQ(0u, notesOf("'#ffffff'"));
}

TEST_F(LoadOwnProfile, TakesPlainSpellingsAndActive)
{
    const VolumeProfileLoadResult result = Load("ScreenSpaceOutline:\n"
                                                "  active: false\n"
                                                "  enable: 1\n"
                                                "  outlineColor: {r: 0, g: 1, b: 0, a: 0.5}\n"
                                                "  outlineWidth: 10\n");
    const auto* outline = result.profile->TryGet<ScreenSpaceOutline>();
    ASSERT_NE(outline, nullptr);
    EXPECT_FALSE(outline->active);
    EXPECT_TRUE(outline->m_Enable.value());
    EXPECT_EQ(outline->m_OutlineColor.value(), (Color{0.0f, 1.0f, 0.0f, 0.5f}));
    EXPECT_EQ(outline->m_OutlineWidth.value(), 10.0f);
}

TEST_F(LoadOwnProfile, KeepsTheOrderOfTheComponents)
{
    const auto profile = Load("TestVolume: {param: 1}\nScreenSpaceOutline:\nMixed:\n").profile;
    ASSERT_EQ(profile->components().size(), 3u);
    EXPECT_EQ(profile->components()[0].get(), profile->TryGet<test::TestVolume>());
    EXPECT_EQ(profile->components()[2].get(), profile->TryGet<test::Mixed>());
}

TEST_F(LoadOwnProfile, SuggestsTheNearestParameter)
{
    const auto path = m_Folder.Write("hero.profile.yaml", "ScreenSpaceOutline:\n"
                                                          "  enable: true\n"
                                                          "  outlneWidth: 4\n");
    EXPECT_THAT(test::ThrownMessage<AssetError>([&] { LoadVolumeProfile(path, m_Registry); }),
                Mentions(path.generic_string() + ":3:3:", "ScreenSpaceOutline", "unknown parameter",
                         "'outlneWidth'", "'outlineWidth'"));
}

TEST_F(LoadOwnProfile, SuggestsTheNearestComponent)
{
    EXPECT_THAT(ProblemsIn("ScreenSpaceOutlin:\n  m_Enable: true\n"),
                ElementsAre(Mentions("1:1:", "unknown volume component", "'ScreenSpaceOutlin'",
                                     "'ScreenSpaceOutline'")));
    EXPECT_THAT(ProblemsIn("Bloom:\n  intensity: 1\n"),
                ElementsAre(Mentions("1:1:", "unknown volume component", "'Bloom'",
                                     "ScreenSpaceOutline, Mixed, TestVolume")));
}

TEST_F(LoadOwnProfile, ReportsEveryProblemOfAFileAtOnce)
{
    EXPECT_THAT(ProblemsIn("ScreenSpaceOutline:\n"
                           "  active: yes\n"
                           "  m_OutlineWidth: 14\n"
                           "  outlineColour: red\n"
                           "  outlineColor: red\n"
                           "Mixed:\n"
                           "  number: .nan\n"
                           "  whole: 1.5\n"
                           "  flag: maybe\n"
                           "Fog: {}\n"),
                ElementsAre(Mentions("2:11: ScreenSpaceOutline.active", "'yes'", "version of YAML",
                                     "true or false"),
                            "3:19: ScreenSpaceOutline.m_OutlineWidth: 14 is outside [1, 10]",
                            Mentions("4:3: ScreenSpaceOutline", "unknown parameter",
                                     "'outlineColour'", "'outlineColor'"),
                            Mentions("5:17: ScreenSpaceOutline.m_OutlineColor", "'red'", "colour",
                                     "\"#FF8000\""),
                            Mentions("7:11: Mixed.number", "'.nan'", "finite"),
                            Mentions("8:10: Mixed.whole", "'1.5'", "whole number"),
                            Mentions("9:9: Mixed.flag", "'maybe'", "true or false"),
                            Mentions("10:1:", "unknown volume component", "'Fog'",
                                     "ScreenSpaceOutline, Mixed, TestVolume")));
}

TEST_F(LoadOwnProfile, RefusesOneParameterInBothSpellings)
{
    EXPECT_THAT(ProblemsIn("ScreenSpaceOutline:\n"
                           "  outlineWidth: 4\n"
                           "  m_OutlineWidth: 5\n"),
                ElementsAre(Mentions("3:3: ScreenSpaceOutline", "'m_OutlineWidth'", "same",
                                     "'outlineWidth'", "2:3")));
}

TEST_F(LoadOwnProfile, RefusesDuplicateKeysAndComponents)
{
    EXPECT_THAT(ProblemsIn("Mixed:\n  flag: 1\n  flag: 0\nMixed:\n"),
                ElementsAre(Mentions("3:3:", "duplicate", "'flag'", "2:3"),
                            Mentions("4:1:", "duplicate", "'Mixed'", "1:1")));
}

TEST_F(LoadOwnProfile, RefusesWhatIsNoMapOfComponents)
{
    EXPECT_THAT(ProblemsIn("- ScreenSpaceOutline\n"),
                ElementsAre(Mentions("1:1:", "sequence", "component", "'ScreenSpaceOutline:'")));
    EXPECT_THAT(ProblemsIn("Mixed: 4\n"), ElementsAre(Mentions("1:8: Mixed", "'4'", "map")));
    EXPECT_THAT(ProblemsIn("Mixed:\n---\nTestVolume:\n"),
                ElementsAre(Mentions("3:1:", "second document", "'---'")));
}

TEST_F(LoadOwnProfile, ReportsAMissingFile)
{
    EXPECT_THAT(Problems([&] { LoadVolumeProfile(m_Folder / "no.profile.yaml", m_Registry); }),
                ElementsAre("there is no such file"));
}

} // namespace

} // namespace limn
