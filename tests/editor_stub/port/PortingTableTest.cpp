#include "port/PortingTable.h"
#include "Paths.h"
#include "TemporaryFolder.h"
#include "port/HeaderWords.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <limn/base/Diagnostic.h>
#include <regex>
#include <set>

namespace limn::test
{

TEST(PortingTable, IsTheOneOfTheReadme)
{
    const std::string path = SourcePath("README.md");
    std::string readme = ReadText(path);
    const std::string head = "| Unity, C# | limn, C++ |\n| --- | --- |\n";
    const std::size_t begin = readme.find(head) + head.size();
    const std::size_t end = readme.find("\n\n", begin) + 1;
    std::string rows;
    for (const std::string& row : UnityPortingTable().rows())
    {
        rows += row + "\n";
    }
    if (std::getenv("LIMN_UPDATE_GOLDEN") != nullptr && rows != readme.substr(begin, end - begin))
    {
        std::ofstream(path) << readme.replace(begin, end - begin, rows);
        FAIL() << "wrote " << path;
    }
    EXPECT_EQ(rows, readme.substr(begin, end - begin))
        << "rows belong into editor_stub/src/port/porting.txt; LIMN_UPDATE_GOLDEN=1 writes the "
           "README's";
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

TEST(PortingTable, RefusesWhatItCannotRead)
{
    for (const auto& [text, problem] :
         {std::pair("same A\nsmae B\n", "porting.txt:2: same, differs, refused or missing, and a "
                                        "name are expected"),
          std::pair("differs A\n", "porting.txt:1: how it differs is expected behind ' : '"),
          std::pair("missing A\n\nsame {A,B}\n", "porting.txt:3: 'A' is said twice"),
          std::pair("| A |\n", "porting.txt:1: '| Unity | limn |' is expected")})
    {
        try
        {
            const PortingTable table(text);
            ADD_FAILURE() << text;
        }
        catch (const ContractError& error)
        {
            EXPECT_EQ(std::string(problem), error.what());
        }
    }
}

} // namespace limn::test
