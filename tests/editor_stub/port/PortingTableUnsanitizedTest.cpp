#include "Mentions.h"
#include "Paths.h"
#include "TemporaryFolder.h"
#include "port/HeaderWords.h"
#include "port/PortingTable.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <limn/base/Diagnostic.h>
#include <regex>
#include <set>
#include <sstream>

namespace limn::test
{

namespace
{

/// The rows below the head of the table of differences, as they stand in a page.
struct TableInPage
{
    explicit TableInPage(const std::string& page)
    {
        const std::string head = "| Unity, C# | limn, C++ |\n| --- | --- |\n";
        begin = page.find(head) + head.size();
        rows = page.substr(begin, page.find("\n\n", begin) + 1 - begin);
    }

    std::size_t begin = 0;
    std::string rows;
};

} // namespace

TEST(PortingTable, IsTheOneOfTheDifferences)
{
    const std::string path = SourcePath("samples/porting/DIFFERENCES.md");
    std::string page = ReadText(path);
    const TableInPage table(page);
    std::string rows;
    for (const std::string& row : UnityPortingTable().rows())
    {
        rows += row + "\n";
    }
    if (std::getenv("LIMN_UPDATE_GOLDEN") != nullptr && rows != table.rows)
    {
        std::ofstream(path) << page.replace(table.begin, table.rows.size(), rows);
        FAIL() << "wrote " << path;
    }
    EXPECT_EQ(rows, table.rows) << "rows belong into editor_stub/src/port/porting.txt; "
                                   "LIMN_UPDATE_GOLDEN=1 writes those of the page";
}

TEST(PortingTable, HasTheRowsThatTheReadmeShows)
{
    std::istringstream shown(TableInPage(ReadText(SourcePath("README.md"))).rows);
    int count = 0;
    for (std::string row; std::getline(shown, row); ++count)
    {
        EXPECT_THAT(UnityPortingTable().rows(), testing::Contains(row));
    }
    EXPECT_EQ(8, count);
}

TEST(PortingTable, SaysSameOfWhatTheHeadersHaveAndMissingOfWhatTheyHaveNot)
{
    const HeaderWords headers;
    int same = 0;
    int missing = 0;
    for (const auto& [key, entry] : UnityPortingTable().entries())
    {
        const std::size_t dot = key.rfind('.');
        const std::string owner = key.substr(0, dot);
        const std::string type = owner.substr(owner.rfind('.') + 1); // of "GraphicsBuffer.Target"
        const std::string member = dot == std::string::npos ? "" : key.substr(dot + 1);
        if (entry.verdict == PortVerdict::Same)
        {
            ++same;
            EXPECT_TRUE(headers.Has(CppType(type), member))
                << key << " is the 'same' in porting.txt, and not in the headers";
        }
        else if (entry.verdict == PortVerdict::Missing && !member.empty() && member != "*")
        {
            ++missing;
            EXPECT_FALSE(headers.Has(CppType(type), member))
                << key
                << " is 'missing' in porting.txt, and in the headers: is it the same, or "
                   "does it differ?";
        }
    }
    EXPECT_GT(same, 400);
    EXPECT_GT(missing, 0);
}

TEST(PortingTable, ReadsKeysWordsAndResults)
{
    const PortingTable table("# a comment\n"
                             "| `A.b` | `b()` |\n"
                             "    differs A.b>C {D,E}.{f,g>H}\n"
                             "    same A\n"
                             "\n"
                             "missing X.* : do without\n");
    EXPECT_EQ((std::vector<std::string>{"| `A.b` | `b()` |"}), table.rows());
    ASSERT_NE(nullptr, table.Find("A", "b"));
    EXPECT_EQ("`A.b` → `b()`", table.Find("A", "b")->words);
    EXPECT_EQ("C", table.Find("A", "b")->result);
    EXPECT_EQ("H", table.Find("E", "g")->result);
    EXPECT_EQ("", table.Find("D.f")->result);
    EXPECT_EQ(PortVerdict::Same, table.Find("A")->verdict);
    EXPECT_EQ("do without", table.Find("X", "anything")->words);
    EXPECT_EQ(nullptr, table.Find("A", "c"));
    EXPECT_TRUE(table.HasType("D"));
    EXPECT_FALSE(table.HasType("H"));
}

TEST(PortingTable, ReadsTheCppOfMembersThatDiffer)
{
    const PortingTable table("differs A.{b,c} A.* : a function\n"
                             "same Texture.width\n"
                             "cpp A.b>D* A.c>int = @%()\n"
                             "cpp A.c := @SetC($1)\n"
                             "cpp new:A = make($*)\n"
                             "cpp new:A/2 A.b/1 = two($1)\n"
                             "names A.b = first second=B::Two\n");
    ASSERT_EQ(2u, table.ParametersOf("A.b").size());
    EXPECT_EQ("first", table.ParametersOf("A.b")[0].name);
    EXPECT_EQ("", table.ParametersOf("A.b")[0].otherwise);
    EXPECT_EQ("second", table.ParametersOf("A.b")[1].name);
    EXPECT_EQ("B::Two", table.ParametersOf("A.b")[1].otherwise);
    EXPECT_TRUE(table.ParametersOf("A.c").empty());
    EXPECT_EQ("@%()", table.Find("A", "b")->cpp);
    EXPECT_EQ("D", table.Find("A", "b")->result);
    EXPECT_TRUE(table.Find("A", "b")->isPointer);
    EXPECT_FALSE(table.Find("A", "c")->isPointer);
    EXPECT_EQ("@SetC($1)", table.Find("A", "c")->cppSet);
    EXPECT_EQ("make($*)", table.CodeFor("new:A", 3));
    EXPECT_EQ("two($1)", table.CodeFor("new:A", 2));
    EXPECT_EQ("two($1)", table.CodeFor("A.b", 1));
    EXPECT_EQ("", table.CodeFor("A.b", 2));
    EXPECT_EQ("Texture", table.OwnerOf("RenderTexture", "width"));
    EXPECT_EQ("A", table.OwnerOf("A", "other"));
    EXPECT_EQ("", table.OwnerOf("A", "other", true));
}

TEST(PortingTable, RefusesWhatItCannotRead)
{
    const std::pair<const char*, std::vector<std::string>> cases[] = {
        {"same A\nsmae B\n", {"porting.txt:2:", "same, differs, refused", "name"}},
        {"differs A\n", {"porting.txt:1:", "how it differs", "' : '"}},
        {"missing A\n\nsame {A,B}\n", {"porting.txt:3:", "'A'", "two rows"}},
        {"same A.b\ncpp A.b\n", {"porting.txt:2:", "' = '", "' := '"}},
        {"same A.b\ncpp A.c = =\n", {"porting.txt:2:", "'A.c'", "no verdict"}},
        {"names A.b first\n", {"porting.txt:1:", "'names KEY = PARAMETER ...'"}},
        {"| A |\n", {"porting.txt:1:", "'| Unity | limn |'"}}};
    for (const auto& [text, parts] : cases)
    {
        try
        {
            const PortingTable table(text);
            ADD_FAILURE() << text;
        }
        catch (const ContractError& error)
        {
            EXPECT_THAT(error.what(), MentionsInOrder(parts));
        }
    }
}

} // namespace limn::test
