#include "Mentions.h"
#include "Paths.h"
#include "Problems.h"
#include "TestComponents.h"
#include "parameters/AllParameters.h"

#include "TemporaryFolder.h"
#include "core/FileSizeLimit.h"
#include <fstream>
#include <future>
#include <gmock/gmock.h>
#include <iterator>
#include <limn/volume/ProfileEdit.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;

const TestRegistry k_Registry;

std::string Edit(const std::string& text, const std::vector<std::string>& edits)
{
    std::vector<ValueAssignment> parsed;
    for (const std::string& edit : edits)
    {
        parsed.push_back(ValueAssignment::Parse(edit, edit));
    }
    return EditVolumeProfile(text, "x.yaml", parsed, k_Registry);
}

std::vector<std::string> ProblemsOf(const std::string& text, const std::vector<std::string>& edits)
{
    return Problems([&] { Edit(text, edits); });
}

std::string ContentOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// `text` with its only `from` made `to`.
std::string With(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    EXPECT_EQ(text.find(from, at + 1), std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

constexpr const char* k_Text = "# A comment, with a ü\n"
                               "ScreenSpaceOutline:   # the outline\n"
                               "    outlineWidth:  4.0   # pixels\n"
                               "\n"
                               "    m_OutlineColor: {r: 0.2,  g: 1.0, b: 0.35}\n"
                               "    m_Enable: true\n"
                               "Mixed: {flag: 1, number: 4.0, tint: [0, 0, 0.50]}\n";

const std::string k_Outline = "ScreenSpaceOutline.";

} // namespace

TEST(EditVolumeProfile, ChangesOneScalarAndNoOtherByte)
{
    EXPECT_EQ(With(k_Text, "4.0   #", "7.5   #"), Edit(k_Text, {k_Outline + "m_OutlineWidth=7.5"}));
    EXPECT_EQ(With(k_Text, "true", "false"), Edit(k_Text, {k_Outline + "enable=false"}));
    EXPECT_EQ(With(k_Text, "number: 4.0", "number: -12"), Edit(k_Text, {"Mixed.number=-12"}));
}

TEST(EditVolumeProfile, KeepsWindowsLineEndsAndAByteOrderMark)
{
    const std::string text = "\xEF\xBB\xBFScreenSpaceOutline: {outlineWidth: 4}\r\n"
                             "Mixed:\r\n\tnumber: 1\r\n";
    const std::string good = With(text, "\t", "  ");
    EXPECT_EQ(With(good, "outlineWidth: 4", "outlineWidth: 10"),
              Edit(good, {k_Outline + "outlineWidth=10"}));
    EXPECT_EQ(With(good, "number: 1\r", "number: 0.5\r"), Edit(good, {"Mixed.number=0.5"}));
}

TEST(EditVolumeProfile, ChangesOnlyTheChannelsOfAColourThatDiffer)
{
    EXPECT_EQ(With(k_Text, "r: 0.2, ", "r: 1, "),
              Edit(k_Text, {k_Outline + "outlineColor=[1, 1, 0.35]"}));
    EXPECT_EQ(With(k_Text, "[0, 0, 0.50]", "[0, 1, 0.50]"),
              Edit(k_Text, {"Mixed.tint={r: 0, g: 1, b: 0.5}"}));
    EXPECT_EQ(
        "Mixed:\n  tint:\n    r: 1 # red\n    g: 0\n    b: 0\n",
        Edit("Mixed:\n  tint:\n    r: 0.5 # red\n    g: 0\n    b: 0\n", {"Mixed.tint=#ff0000"}));
}

TEST(EditVolumeProfile, KeepsAColourInHexDigitsWhereTheyHoldIt)
{
    EXPECT_EQ("Mixed: {tint: '#00ff80'} # c\n",
              Edit("Mixed: {tint: '#ffaa00'} # c\n", {"Mixed.tint=#00FF80"}));
    EXPECT_EQ("Mixed: {tint: \"#00FF8040\"}\n",
              Edit("Mixed: {tint: \"#112233\"}\n", {"Mixed.tint=#00FF8040"}));
    EXPECT_EQ("Mixed: {tint: {r: 2.5, g: 0, b: 0, a: 1}}\n",
              Edit("Mixed: {tint: \"#112233\"}\n", {"Mixed.tint=[2.5, 0, 0]"}));
}

TEST(EditVolumeProfile, LeavesAValueThatSaysTheSameAsItIs)
{
    EXPECT_EQ(k_Text, Edit(k_Text, {k_Outline + "outlineWidth=4", "Mixed.flag=true",
                                    "Mixed.tint=[0, 0, 0.5, 1]"}));
}

TEST(EditVolumeProfile, ChangesWhetherAComponentIsActive)
{
    EXPECT_EQ("Mixed: {active: false}\n", Edit("Mixed: {active: true}\n", {"Mixed.active=false"}));
}

TEST(EditVolumeProfile, ChangesTheValueAndNotTheStateInAUnityAsset)
{
    const std::string text =
        ContentOf(test::SourcePath("tests/volume/data/SampleSceneProfile.asset"));
    EXPECT_EQ(With(text, "m_Value: 10", "m_Value: 4.5"),
              Edit(text, {k_Outline + "outlineWidth=4.5"}));
    EXPECT_EQ(With(text, "g: 0.49606514", "g: 0.25"),
              Edit(text, {k_Outline + "m_OutlineColor=[0, 0.25, 1]"}));
    EXPECT_EQ(
        With(text, "m_OverrideState: 1\n    m_Value: 1\n", "m_OverrideState: 1\n    m_Value: 0\n"),
        Edit(text, {k_Outline + "m_Enable=false"}));
}

TEST(EditVolumeProfile, RefusesNamesAndValuesThatAreWrongAllAtOnce)
{
    EXPECT_THAT(
        ProblemsOf(k_Text, {k_Outline + "outlineWidth=14", k_Outline + "outlneWidth=4",
                            "ScreenSpaceOutlin.outlineWidth=4", "Mixed.flag=maybe"}),
        ElementsAre(
            Mentions("ScreenSpaceOutline.m_OutlineWidth", "14", "outside", "[1, 10]"),
            Mentions("ScreenSpaceOutline", "unknown parameter", "'outlneWidth'", "'outlineWidth'"),
            Mentions("unknown volume component", "'ScreenSpaceOutlin'", "'ScreenSpaceOutline'"),
            Mentions("Mixed.flag", "'maybe'", "true or false")));
}

TEST(EditVolumeProfile, AddsWhatTheFileLacksInItsOwnStyle)
{
    EXPECT_EQ(With(k_Text, "0.50]}", "0.50], whole: 3}"), Edit(k_Text, {"Mixed.whole=3"}));
    EXPECT_EQ(std::string(k_Text) + "TestVolume:\n  param: 1\n",
              Edit(k_Text, {"TestVolume.param=1"}));
    // As a line behind the last one, indented and spelt as the lines there.
    EXPECT_EQ("ScreenSpaceOutline:\r\n   enable: true # on\r\n   outlineWidth: 4\r\nMixed: {}\r\n",
              Edit("ScreenSpaceOutline:\r\n   enable: true # on\r\nMixed: {}\r\n",
                   {k_Outline + "m_OutlineWidth=4"}));
    EXPECT_EQ("ScreenSpaceOutline:\n  m_Enable: true\n  m_OutlineWidth: 4",
              Edit("ScreenSpaceOutline:\n  m_Enable: true", {k_Outline + "outlineWidth=4"}));
    EXPECT_EQ("Mixed:\n  number: 2\nTestVolume: {param: 1}\n",
              Edit("Mixed:\nTestVolume: {param: 1}\n", {"Mixed.number=2"}));
    EXPECT_EQ("Mixed: {number: 2}\n", Edit("Mixed: {}\n", {"Mixed.number=2"}));
    EXPECT_EQ("{Mixed: {number: 2}}\n", Edit("{}\n", {"Mixed.number=2"}));
    EXPECT_EQ("Mixed: {number: 1, active: false}\n",
              Edit("Mixed: {number: 1}\n", {"Mixed.active=false"}));
}

TEST(EditVolumeProfile, AddsNothingToAFileOfUnitys)
{
    const std::string text =
        ContentOf(test::SourcePath("tests/volume/data/SampleSceneProfile.asset"));
    EXPECT_THAT(ProblemsOf(text, {"Mixed.whole=3"}),
                ElementsAre(Mentions("Mixed.whole", "does not have it", "Unity")));
}

TEST(EditVolumeProfile, ChangesOneNumberOfAColour)
{
    EXPECT_EQ(With(k_Text, "g: 1.0", "g: 0.5"), Edit(k_Text, {k_Outline + "m_OutlineColor.g=0.5"}));
    EXPECT_EQ(With(k_Text, "[0, 0, 0.50]", "[0, 0, 0.75]"), Edit(k_Text, {"Mixed.tint.b+=0.25"}));
    EXPECT_THAT(
        ProblemsOf(k_Text, {k_Outline + "outlineColor.q=1"}),
        ElementsAre(testing::AllOf(testing::HasSubstr("m_OutlineColor"), testing::HasSubstr("'q'"),
                                   testing::HasSubstr("did you mean 'r'?"))));
}

TEST(EditVolumeProfile, StartsFromTheNumberThatThereIs)
{
    EXPECT_EQ(With(k_Text, "4.0   #", "4.1   #"),
              Edit(k_Text, {k_Outline + "m_OutlineWidth+=0.1"}));
    EXPECT_EQ(With(k_Text, "4.0   #", "1.5   #"),
              Edit(k_Text, {k_Outline + "m_OutlineWidth-=2.5"}));
    EXPECT_EQ(With(k_Text, "4.0   #", "10   #"), Edit(k_Text, {k_Outline + "m_OutlineWidth*=2.5"}));
    // Of what the file lacks, from the default: TestComponents.h has 3 for the width.
    EXPECT_EQ("ScreenSpaceOutline: {m_OutlineWidth: 5}\n",
              Edit("ScreenSpaceOutline: {}\n", {k_Outline + "m_OutlineWidth+=2"}));
    EXPECT_THAT(
        ProblemsOf(k_Text,
                   {k_Outline + "m_OutlineWidth*=9", k_Outline + "enable+=1", "Mixed.number+=x"}),
        ElementsAre(Mentions("ScreenSpaceOutline.m_OutlineWidth", "36", "outside", "[1, 10]"),
                    Mentions("+=", "numbers", "true"), Mentions("+=", "numbers", "'x'")));
}

TEST(EditVolumeProfile, RefusesWhatAnAliasRepeats)
{
    const std::string text = "Mixed: {number: &n 4}\nTestVolume: {param: *n}\n";
    EXPECT_THAT(ProblemsOf(text, {"Mixed.number=5"}),
                ElementsAre(Mentions("1:17: Mixed.number", "alias", "by hand")));
    EXPECT_THAT(ProblemsOf(text, {"TestVolume.param=5"}),
                ElementsAre(Mentions("1:17: TestVolume.param", "alias", "by hand")));
    EXPECT_EQ("Mixed: {number: &n 5}\n", Edit("Mixed: {number: &n 4}\n", {"Mixed.number=5"}));
}

TEST(EditVolumeProfile, RefusesAFormThatCannotHoldTheNewValue)
{
    EXPECT_THAT(ProblemsOf("Mixed: {tint: [0, 0, 0]}\n", {"Mixed.tint=[0, 0, 0, 0.5]"}),
                ElementsAre(Mentions("1:15: Mixed.tint", "list of 3", "4", "by hand")));
    EXPECT_THAT(ProblemsOf("Mixed: {tint: {r: 0, g: 0, b: 0}}\n", {"Mixed.tint=[0, 0, 0, 0.5]"}),
                ElementsAre(Mentions("1:15: Mixed.tint", "'a'", "missing", "'a: 0.5'")));
}

TEST(SetScalars, ReplacesTheFileBehindALinkAndKeepsItsPermissions)
{
    const TemporaryFolder folder;
    const auto file = folder.Write("a.profile.yaml", "Mixed: {number: 1}\n");
    std::filesystem::create_symlink(file, folder / "link");
    const auto mode = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
    std::filesystem::permissions(file, mode);
    const std::vector<ValueAssignment> edits{{"Mixed.number", "2"}};
    SetScalars(folder / "link", edits, k_Registry);
    EXPECT_EQ("Mixed: {number: 2}\n", ContentOf(file));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(mode, std::filesystem::status(file).permissions());
}

TEST(SetScalars, OnAFullDiskLeavesTheOldFileAndNothingBesideIt)
{
    const TemporaryFolder folder;
    const std::string text = "Mixed: {number: 1}\n#" + std::string(8000, 'x') + "\n";
    const auto file = folder.Write("a.profile.yaml", text);
    const std::vector<ValueAssignment> edits{{"Mixed.number", "2"}};
    std::vector<std::string> problems;
    {
        const FileSizeLimit limit(4096);
        problems = Problems([&] { SetScalars(file, edits, k_Registry); });
    }
    EXPECT_THAT(problems, ElementsAre("the file cannot be written: File too large"));
    EXPECT_EQ(text, ContentOf(file));
    EXPECT_EQ(1, folder.fileCount());
}

TEST(SetScalars, LosesNothingOfWhatAnotherSetsAtTheSameTime)
{
    const TemporaryFolder folder;
    const auto file =
        folder.Write("a.profile.yaml", "Mixed: {number: 0}\nTestVolume: {param: 0}\n");
    constexpr int k_Rounds = 30;
    const auto setAll = [&file](const char* component, const char* parameter)
    {
        int lost = 0;
        const TestRegistry registry;
        for (int i = 1; i <= k_Rounds; ++i)
        {
            const std::vector<ValueAssignment> edits{
                {std::string(component) + "." + parameter, std::to_string(i)}};
            SetScalars(file, edits, registry);
            const std::string line = std::string(parameter) + ": " + std::to_string(i) + "}";
            lost += ContentOf(file).find(line) == std::string::npos ? 1 : 0;
        }
        return lost;
    };
    auto other = std::async(std::launch::async, setAll, "TestVolume", "param");
    EXPECT_EQ(0, setAll("Mixed", "number"));
    EXPECT_EQ(0, other.get());
    EXPECT_EQ("Mixed: {number: 30}\nTestVolume: {param: 30}\n", ContentOf(file));
}

TEST(SetScalars, KeepsEveryNameOfTheFile)
{
    const TemporaryFolder folder;
    const auto file = folder.Write("a.profile.yaml", "Mixed: {number: 1}\n");
    std::filesystem::create_hard_link(file, folder / "b.profile.yaml");
    const std::vector<ValueAssignment> edits{{"Mixed.number", "20"}};
    SetScalars(file, edits, k_Registry);
    EXPECT_EQ("Mixed: {number: 20}\n", ContentOf(folder / "b.profile.yaml"));
}

TEST(ReplaceContent, RefusesAFileThatChangedMeanwhile)
{
    const TemporaryFolder folder;
    const auto file = folder.Write("a.profile.yaml", "new: 1\n");
    EXPECT_THAT(Problems([&] { ReplaceContent(file, "old: 1\n", "mine: 1\n"); }),
                ElementsAre(Mentions("changed", "another program", "try again")));
    EXPECT_EQ("new: 1\n", ContentOf(file));
    EXPECT_EQ(1, folder.fileCount());
}

namespace
{

/// Parameters whose values are more than a scalar.
struct Nested : VolumeComponent
{
    struct Inner : VolumeComponent
    {
        FloatParameter size{this, "m_Size", 1.0f};
    };
    ObjectParameter<Inner> object{this, "m_Object", std::make_unique<Inner>()};
    AnimationCurveParameter curve{this, "m_Curve", {}};
    Texture2DParameter ramp{this, "m_Ramp", {}};
    LayerMaskParameter layers{this, "m_Layers", {}};
};

std::string EditNested(const std::string& text, const std::string& edit)
{
    TestRegistry registry;
    registry.Register<Nested>("Nested");
    const std::vector<ValueAssignment> edits{ValueAssignment::Parse(edit, edit)};
    return EditVolumeProfile(text, "x.yaml", edits, registry);
}

} // namespace

TEST(EditVolumeProfile, ReachesIntoAnObject)
{
    EXPECT_EQ("Nested: {object: {size: 4.5}} # c\n",
              EditNested("Nested: {object: {size: 1}} # c\n", "Nested.object.size=4.5"));
    EXPECT_EQ("Nested: {m_Object: {m_Size: {m_OverrideState: 0, m_Value: 2}}}\n",
              EditNested("Nested: {m_Object: {m_Size: {m_OverrideState: 0, m_Value: 1}}}\n",
                         "Nested.m_Object.m_Size=2"));
    EXPECT_EQ("Nested: {object: {size: 2}}\n",
              EditNested("Nested: {object: {}}\n", "Nested.object.size=2"));
    EXPECT_EQ("Nested: {m_Object: {m_Size: 2}}\n",
              EditNested("Nested: {}\n", "Nested.object.size=2"));
    EXPECT_THAT(Problems([] { EditNested("Nested: {}\n", "Nested.object.sze=2"); }),
                ElementsAre(Mentions("Nested.m_Object", "unknown parameter", "'sze'", "'size'")));
}

TEST(EditVolumeProfile, ReplacesACurveInBracketsThatGetsAnotherNumberOfKeys)
{
    EXPECT_EQ("Nested:\n  curve: [{time: 0, value: 2, inTangent: 0, outTangent: 0}, {time: 1, "
              "value: 3, inTangent: 0, outTangent: 0}] # bend\n  ramp: a.png\n",
              EditNested("Nested:\n  curve: [{time: 0, value: 1}] # bend\n  ramp: a.png\n",
                         "Nested.curve=[{time: 0, value: 2}, {time: 1, value: 3}]"));
    EXPECT_EQ("Nested: {curve: []}\n",
              EditNested("Nested: {curve: [{time: 0, value: 1}]}\n", "Nested.curve=[]"));
    EXPECT_THAT(
        Problems(
            [] { EditNested("Nested:\n  curve:\n  - {time: 0, value: 1}\n", "Nested.curve=[]"); }),
        ElementsAre(Mentions("3:3: Nested.m_Curve", "list of 1", "0", "by hand")));
}

TEST(EditVolumeProfile, LeavesACurveInBracketsOverSeveralLinesToItsAuthor)
{
    EXPECT_THAT(
        Problems(
            []
            { EditNested("Nested:\n  curve: [\n    {time: 0, value: 1}]\n", "Nested.curve=[]"); }),
        ElementsAre(Mentions("2:10: Nested.m_Curve", "list of 1", "0", "by hand")));
}

TEST(EditVolumeProfile, LeavesATextOverSeveralLinesToItsAuthor)
{
    EXPECT_THAT(
        Problems([] { EditNested("Nested:\n  ramp: \"a\n    b.png\"\n", "Nested.ramp=c.png"); }),
        ElementsAre(Mentions("2:9: Nested.m_Ramp", "one line", "by hand")));
}

TEST(EditVolumeProfile, ChangesOneNumberOfACurveThatKeepsItsKeys)
{
    const std::string text = "Nested:\n  curve:\n  - {time: 0, value: 1, inTangent: 0, outTangent: "
                             "0}\n";
    EXPECT_EQ(With(text, "value: 1", "value: 7"),
              EditNested(text, "Nested.curve=[{time: 0, value: 7}]"));
}

TEST(EditVolumeProfile, SetsAndClearsTexts)
{
    EXPECT_EQ("Nested: {ramp: \"\"}\n", EditNested("Nested: {ramp: a.png}\n", "Nested.ramp="));
    EXPECT_EQ("Nested: {ramp: 'b.png'}\n", EditNested("Nested: {ramp: ''}\n", "Nested.ramp=b.png"));
    EXPECT_EQ("Nested:\n  ramp: \"b.png\" # c\n",
              EditNested("Nested:\n  ramp: # c\n", "Nested.ramp=b.png"));
    EXPECT_EQ("Nested: {ramp: \"b.png\" }\n",
              EditNested("Nested: {ramp: }\n", "Nested.ramp=b.png"));
    EXPECT_THAT(Problems([] { EditNested("Nested: {ramp: ~}\n", "Nested.ramp=b.png"); }),
                ElementsAre(Mentions("1:10: Nested.m_Ramp", "nothing", "\"b.png\"", "by hand")));
    EXPECT_THAT(ProblemsOf("Mixed: {number: 1}\n", {"Mixed.number="}),
                ElementsAre(Mentions("Mixed.number", "''", "quotes", "number")));
}

TEST(EditVolumeProfile, LetsTheLayersOfASceneBe)
{
    EXPECT_EQ("Nested: {layers: [Furniture], ramp: \"b.png\"}\n",
              EditNested("Nested: {layers: [Furniture], ramp: a.png}\n", "Nested.ramp=b.png"));
    EXPECT_EQ("Nested: {layers: 33}\n",
              EditNested("Nested: {layers: [Furniture]}\n", "Nested.layers=[Default, UI]"));
}

} // namespace limn::test
