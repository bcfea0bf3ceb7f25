#include "Mentions.h"
#include "Problems.h"

#include "TemporaryFolder.h"
#include <core/ThrownMessage.h>
#include <gmock/gmock.h>
#include <limn/volume/YamlNode.h>

namespace limn
{

namespace
{

using test::Mentions;
using test::Problems;
using testing::ElementsAre;

std::vector<std::string> ProblemsIn(const std::string& text)
{
    return Problems([&] { ParseYaml(text, "x.yaml"); });
}

TEST(ParseYaml, KeepsKindsOrderQuotesAndPlaces)
{
    const YamlNode root = ParseYaml("zeta: 4\n"
                                    "alpha: [a, 'b']\n"
                                    "nothing:\n"
                                    "inner:\n"
                                    "  key: \"4\"\n",
                                    "x.yaml")
                              .front();
    ASSERT_TRUE(root.isMap());
    ASSERT_EQ(root.entries().size(), 4u);
    EXPECT_EQ(root.entries()[0].key, "zeta");
    EXPECT_EQ(root.entries()[1].key, "alpha");
    EXPECT_EQ(root.entries()[1].keyLocation, (SourceLocation{2, 1}));

    EXPECT_EQ(root.Find("zeta")->scalar(), "4");
    EXPECT_FALSE(root.Find("zeta")->isQuoted());
    EXPECT_EQ(root.Find("zeta")->location(), (SourceLocation{1, 7}));

    const YamlNode& alpha = *root.Find("alpha");
    ASSERT_TRUE(alpha.isSequence());
    EXPECT_EQ(alpha.items()[1].scalar(), "b");
    EXPECT_TRUE(alpha.items()[1].isQuoted());
    EXPECT_EQ(alpha.items()[1].location(), (SourceLocation{2, 12}));

    EXPECT_TRUE(root.Find("nothing")->isNull());
    EXPECT_EQ(root.Find("nothing")->location(), (SourceLocation{3, 1}));
    EXPECT_TRUE(root.Find("inner")->Find("key")->isQuoted());
    EXPECT_EQ(root.Find("absent"), nullptr);
    EXPECT_EQ(alpha.Find("a"), nullptr);
}

TEST(ParseYaml, ReadsFilesWithWindowsLineEndsAndAByteOrderMark)
{
    const YamlNode root = ParseYaml("\xEF\xBB\xBF"
                                    "a: 1\r\nb: two words\r\n",
                                    "x.yaml")
                              .front();
    EXPECT_EQ(root.Find("a")->scalar(), "1");
    EXPECT_EQ(root.Find("b")->scalar(), "two words");
    EXPECT_EQ(root.Find("b")->location(), (SourceLocation{2, 4}));
}

TEST(ParseYaml, GivesEveryDocumentWithTagAndAnchor)
{
    const std::vector<YamlNode> documents = ParseYaml("%YAML 1.1\n"
                                                      "%TAG !u! tag:unity3d.com,2011:\n"
                                                      "--- !u!114 &-7893295128165547882\n"
                                                      "MonoBehaviour:\n"
                                                      "  m_Name: Bloom\n"
                                                      "--- !u!78 &1\n"
                                                      "TagManager:\n"
                                                      "  tags: []\n",
                                                      "x.asset");
    ASSERT_EQ(documents.size(), 2u);
    EXPECT_EQ(documents[0].tag(), "tag:unity3d.com,2011:114");
    EXPECT_EQ(documents[0].anchor(), "-7893295128165547882");
    EXPECT_EQ(documents[1].tag(), "tag:unity3d.com,2011:78");
    EXPECT_EQ(documents[1].anchor(), "1");
    EXPECT_TRUE(documents[1].Find("TagManager")->Find("tags")->isSequence());
}

TEST(ParseYaml, RepeatsAnAnchorsValueForItsAliases)
{
    const YamlNode root =
        ParseYaml("a: &x {r: 1}\nb: *x\nc: &y 5\nd: [*y, *y]\n", "x.yaml").front();
    EXPECT_EQ(root.Find("b")->Find("r")->scalar(), "1");
    EXPECT_EQ(root.Find("b")->location(), (SourceLocation{1, 4})); // where the text stands
    EXPECT_EQ(root.Find("d")->items()[1].scalar(), "5");
}

TEST(ParseYaml, ReportsEveryDuplicateKeyWithBothPlaces)
{
    EXPECT_THAT(ProblemsIn("a: 1\nb: {c: 1, c: 2}\na: 2\na: 3\n"),
                ElementsAre(Mentions("2:11:", "duplicate", "'c'", "2:5"),
                            Mentions("3:1:", "duplicate", "'a'", "1:1"),
                            Mentions("4:1:", "duplicate", "'a'", "1:1")));
}

TEST(ParseYaml, RefusesKeysThatAreNotText)
{
    EXPECT_THAT(ProblemsIn("? [a]\n: 1\nnull: 2\n"),
                ElementsAre(Mentions("1:3:", "key is a sequence", "plain text"),
                            Mentions("3:1:", "key is nothing", "plain text")));
}

TEST(ParseYaml, PointsAtSyntaxErrors)
{
    EXPECT_THAT(ProblemsIn("a:\n  b: 1\n c: 2\n"),
                ElementsAre(Mentions("3:2:", "YAML", "does not belong", "indentation")));
    EXPECT_THAT(ProblemsIn("a: b: c\n"),
                ElementsAre(Mentions("1:5:", "YAML", "':'", "out of place", "quotes")));
    EXPECT_THAT(ProblemsIn("a: 1\nb: [1,\nc: 2\n"),
                ElementsAre(Mentions("2:4:", "YAML", "'['", "']'")));
    EXPECT_THAT(ProblemsIn("a: {b: 1\n"), ElementsAre(Mentions("1:4:", "YAML", "'{'", "'}'")));
    EXPECT_THAT(ProblemsIn("a: 1\n\tb: 2\n"),
                ElementsAre(Mentions("2:1:", "YAML", "tab", "spaces")));
    EXPECT_THAT(ProblemsIn("a: *nobody\n"),
                ElementsAre(Mentions("1:4:", "YAML", "anchor", "not defined")));
}

TEST(ParseYaml, RefusesAQuoteThatIsNeverClosed)
{
    EXPECT_THAT(ProblemsIn("a: 1\nb: \"x\nc: 3\n"),
                ElementsAre(Mentions("2:4:", "YAML", "quote", "never closed")));
    EXPECT_THAT(ProblemsIn("b: &anchor 'it''s\n"),
                ElementsAre(Mentions("1:4:", "YAML", "quote", "never closed")));
    EXPECT_EQ(ParseYaml("a: 'it''s'\nb: \"say \\\"x\\\"\"\n", "x.yaml").front().Find("b")->scalar(),
              "say \"x\"");
}

TEST(ParseYaml, RefusesTextBehindTheEndOfADocument)
{
    EXPECT_THAT(ProblemsIn("- 1\na: 2\n"),
                ElementsAre(Mentions("2:1:", "end of the document", "'---'")));
    EXPECT_THAT(ProblemsIn("{a: 1} b\n"),
                ElementsAre(Mentions("1:8:", "end of the document", "'---'")));
}

TEST(ParseYaml, RefusesEmptyTexts)
{
    const auto message = Mentions("empty", "'name:'");
    EXPECT_THAT(ProblemsIn(""), ElementsAre(message));
    EXPECT_THAT(ProblemsIn("# only a comment\n\n"), ElementsAre(message));
    EXPECT_THAT(ProblemsIn("---\n"), ElementsAre(message));
}

TEST(ParseYaml, RefusesWhatIsNotUtf8Text)
{
    EXPECT_THAT(ProblemsIn(std::string("a: 1\nb\0c", 8)),
                ElementsAre(Mentions("2:2:", "NUL", "binary", "UTF-16")));
    const auto notUtf8 = Mentions("1:4:", "not UTF-8", "save");
    EXPECT_THAT(ProblemsIn("a: \xE4\n"), ElementsAre(notUtf8));         // Latin-1
    EXPECT_THAT(ProblemsIn("a: \xC0\xAF\n"), ElementsAre(notUtf8));     // overlong
    EXPECT_THAT(ProblemsIn("a: \xED\xA0\x80\n"), ElementsAre(notUtf8)); // surrogate
    EXPECT_EQ(
        ParseYaml("a: \xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80\n", "x").front().Find("a")->scalar(),
        "\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80");
}

TEST(ParseYaml, RefusesMoreThan64Levels)
{
    const auto nested = [](std::size_t levels)
    {
        return std::string(levels, '[') + std::string(levels, ']');
    };
    EXPECT_EQ(ParseYaml(nested(64), "x.yaml").size(), 1u);
    EXPECT_THAT(ProblemsIn(nested(65)), ElementsAre(Mentions("1:65:", "nested", "64 levels")));
    EXPECT_THAT(ProblemsIn(nested(100000)), ElementsAre(Mentions("1:65:", "nested", "64 levels")));
}

TEST(ParseYaml, CountsLevelsThroughAliases)
{
    std::string text = "a0: &a0 [1]\n";
    for (int i = 1; i < 64; ++i)
    {
        const std::string before = std::to_string(i - 1);
        const std::string name = std::to_string(i);
        text += "a" + name + ": &a" + name + " [*a" + before + "]\n";
    }
    EXPECT_THAT(ProblemsIn(text), ElementsAre(Mentions("64:12:", "nested", "64 levels")));
}

TEST(ParseYaml, RefusesAnAliasInsideItsOwnAnchor)
{
    EXPECT_THAT(ProblemsIn("a: &x [1, *x]\n"),
                ElementsAre(Mentions("1:11:", "alias", "contains it")));
}

TEST(ParseYaml, RefusesAliasesThatMultiplyWithoutEnd)
{
    std::string text = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
    for (int i = 1; i < 9; ++i)
    {
        const std::string before = "*a" + std::to_string(i - 1);
        const std::string name = "a" + std::to_string(i);
        text += name + ": &" + name + " [" + before;
        for (int k = 1; k < 10; ++k)
        {
            text += ", " + before;
        }
        text += "]\n";
    }
    EXPECT_THAT(ProblemsIn(text), ElementsAre(Mentions("aliases", "1000000")));
}

TEST(ParseYaml, CountsOnlyAliasesAgainstTheLimitOfWhatTheyRepeat)
{
    const YamlLimits limits{.repeatedValues = 3};
    EXPECT_EQ(1'000'000u, YamlLimits{}.repeatedValues);
    EXPECT_EQ(ParseYaml("- 1\n- 1\n- 1\n- 1\n- 1\n", "x.yaml", limits).front().items().size(), 5u);
}

TEST(ParseYaml, RefusesMoreThanTheLimits)
{
    const auto problems = [](const std::string& text, const YamlLimits& limits)
    {
        return test::Problems([&] { ParseYaml(text, "x.yaml", limits); });
    };
    EXPECT_EQ(5'000'000u, YamlLimits{}.values);
    EXPECT_EQ(ParseYaml("[1, 2, 3]\n", "x.yaml", {.values = 4}).front().items().size(), 3u);
    EXPECT_THAT(problems("[1, 2, 3, 4]\n", {.values = 4}),
                ElementsAre(Mentions("1:11:", "more than 4 values")));
    EXPECT_THAT(problems("[[[1]]]\n", {.depth = 2}),
                ElementsAre(Mentions("1:3:", "nested", "2 levels")));
    EXPECT_THAT(problems("a: &x [1, 2]\nb: *x\nc: *x\n", {.repeatedValues = 5}),
                ElementsAre(Mentions("3:4:", "aliases", "5")));
    EXPECT_THAT(problems("a: [1, 2]\n", {.flowBytes = 5}),
                ElementsAre(Mentions("1:4:", "brackets", "5 bytes", "'- '")));
}

TEST(ParseYaml, RefusesAListInBracketsAbove8MiBBeforeItReadsIt)
{
    const std::size_t limit = std::size_t{8} * 1024 * 1024;
    const auto message = Mentions("2:7:", "brackets", "8388608 bytes", "'- '");
    std::string list = "a: 1\nb: &x [";
    while (list.size() < limit + 20)
    {
        list += "1,";
    }
    EXPECT_THAT(ProblemsIn(list + "1]\n"), ElementsAre(message));
    EXPECT_THAT(ProblemsIn(list), ElementsAre(message));
}

TEST(ParseYaml, FindsNoListInsideTextAndComments)
{
    const std::string filler = "# " + std::string(std::size_t{9} * 1024 * 1024, 'x') + "\n";
    const YamlNode root = ParseYaml("a: is [ this\nb: '[ '' ['\nc: \"{ \\\" [\"\nd: [1] # [\n" +
                                        filler + "e: it's {\n",
                                    "x.yaml")
                              .front();
    EXPECT_EQ(root.Find("a")->scalar(), "is [ this");
    EXPECT_EQ(root.Find("b")->scalar(), "[ ' [");
    EXPECT_EQ(root.Find("c")->scalar(), "{ \" [");
    EXPECT_EQ(root.Find("e")->scalar(), "it's {");
}

TEST(LoadYamlFile, NamesTheFileInEveryProblem)
{
    const test::TemporaryFolder folder;
    const auto path = folder.Write("broken.yaml", "a: 1\na: 2\n");
    EXPECT_THAT(test::ThrownMessage<AssetError>([&] { LoadYamlFile(path); }),
                Mentions(path.generic_string() + ":2:1:", "duplicate", "'a'", "1:1"));
}

TEST(LoadYamlFile, SaysWhatIsWrongWithTheFileItself)
{
    const test::TemporaryFolder folder;
    EXPECT_THAT(Problems([&] { LoadYamlFile(folder / "absent.yaml"); }),
                ElementsAre("there is no such file"));
    EXPECT_THAT(Problems([&] { LoadYamlFile(folder / "."); }),
                ElementsAre("this is a folder; a file is expected"));

    const auto huge = folder.Write("huge.yaml", "a: 1\n");
    std::filesystem::resize_file(huge, 64u * 1024 * 1024 + 1);
    EXPECT_THAT(Problems([&] { LoadYamlFile(huge); }),
                ElementsAre("the file has 67108865 bytes; at most 67108864 (64 MiB) are read"));
}

TEST(LoadYamlFile, RefusesAFileWithoutContentAndOneThatIsNoFile)
{
    const test::TemporaryFolder folder;
    const auto empty = folder.Write("empty.yaml", "");
    EXPECT_THAT(Problems([&] { LoadYamlFile(empty); }), ElementsAre(Mentions("empty", "'name:'")));
    EXPECT_THAT(Problems([] { LoadYamlFile("/dev/null"); }),
                ElementsAre("this is a device; a file is expected"));
}

TEST(LoadYamlFile, ReadsBackWhatWasWritten)
{
    const test::TemporaryFolder folder;
    const auto path = folder.Write("good.yaml", "name: x\n");
    EXPECT_EQ(LoadYamlFile(path).front().Find("name")->scalar(), "x");
}

} // namespace

} // namespace limn
