#include "Paths.h"
#include "commands/CommandRun.h"
#include "port/HeaderDocs.h"
#include "port/HeaderWords.h"
#include "port/PortingTable.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace limn::test
{

namespace
{

/// What Unity's types have, as data/unity_members.txt lists it.
struct UnityType
{
    std::string name;
    std::string version; ///< "URP 14"
    std::vector<std::string> members;
};

std::vector<UnityType> ReadUnityTypes()
{
    std::istringstream lines(ReadText(SourcePath("tests/editor_stub/data/unity_members.txt")));
    std::vector<UnityType> types;
    std::string version;
    for (std::string line; std::getline(lines, line);)
    {
        if (line.empty() || line.front() == '#')
        {
            continue;
        }
        if (line.front() == '[')
        {
            version = line.substr(1, line.size() - 2);
            continue;
        }
        if (line.front() != ' ')
        {
            const std::size_t colon = line.find(':');
            types.push_back({line.substr(0, colon), version, {}});
            line = line.substr(colon + 1);
        }
        std::istringstream words(line);
        for (std::string word; words >> word;)
        {
            types.back().members.push_back(word);
        }
    }
    return types;
}

constexpr std::array k_Verdicts{PortVerdict::Same, PortVerdict::Differs, PortVerdict::Refused,
                                PortVerdict::Missing};
using Counts = std::array<int, k_Verdicts.size()>;

/// "| 3 | 1 | 0 | 2 |"
std::string Cells(const Counts& counts)
{
    std::string text = "|";
    for (const int count : counts)
    {
        text += " " + std::to_string(count) + " |";
    }
    return text;
}

/// The table of types and of their members.
class Coverage
{
public:
    explicit Coverage(const std::vector<UnityType>& types)
    {
        for (const UnityType& type : types)
        {
            Add(type);
        }
    }

    std::string Document() const
    {
        return "# What limn has of Unity's interface\n\n"
               "Each public member of the types that a render feature works with "
               "(`tests/editor_stub/data/unity_members.txt`), with its verdict of "
               "`editor_stub/src/port/porting.txt`. A test writes this file.\n\n"
               "**same**: its line goes over as it is, the spelling of the languages apart. "
               "**differs**: the table says how. **refused**: left out on purpose; a call does "
               "not compile, or an exception says why. **missing**: not there, and a call does "
               "not compile; it might come.\n\n"
               "| type | of | same | differs | refused | missing |\n"
               "| --- | --- | --- | --- | --- | --- |\n" +
               m_Table + "| **" + std::to_string(m_Types) + " types** | | " +
               Cells(m_All).substr(2) +
               "\n\n## Each member\n\nHow it differs or why it is not there, and what it is "
               "here: the first sentence that its header has of it.\n" +
               m_Details;
    }

    /// Returns the sentence behind the table of DIFFERENCES.md.
    std::string Sentence() const
    {
        int all = 0;
        for (const int count : m_All)
        {
            all += count;
        }
        return "Of the " + std::to_string(all) + " public members of " + std::to_string(m_Types) +
               " types of Unity 2022.3, URP 14 and 17 that features work with, " +
               std::to_string(m_All[0]) + " are the same here, " + std::to_string(m_All[1]) +
               " differ, " + std::to_string(m_All[2]) + " are left out on purpose and " +
               std::to_string(m_All[3]) + " are missing: [the list of them](COVERAGE.md).";
    }

    /// How many members have a sentence of a header.
    int documented() const { return m_Documented; }

private:
    void Add(const UnityType& type)
    {
        Counts counts{};
        std::string details;
        for (const std::string& member : type.members)
        {
            const PortEntry* entry = UnityPortingTable().Find(type.name, member);
            if (entry == nullptr)
            {
                ADD_FAILURE() << type.name << "." << member << " has no verdict in porting.txt";
                continue;
            }
            ++counts.at(static_cast<std::size_t>(entry->verdict));
            ExpectInHeaders(type.name, member, entry->verdict);
            details += "| `" + member + "` | " + ToString(entry->verdict) + " | " + entry->words +
                       " | " + Here(type.name, member, entry->verdict) + " |\n";
        }
        for (std::size_t i = 0; i < counts.size(); ++i)
        {
            m_All[i] += counts[i];
        }
        ++m_Types;
        m_Table += "| " + type.name + " | " + type.version + " " + Cells(counts) + "\n";
        m_Details += details.empty()
                         ? ""
                         : "\n### " + type.name + ", " + type.version +
                               "\n\n| member | | | here |\n| --- | --- | --- | --- |\n" + details;
    }

    /// In a cell of a table.
    std::string Here(const std::string& type, const std::string& member, PortVerdict verdict) const
    {
        const bool isHere = verdict == PortVerdict::Same || verdict == PortVerdict::Differs;
        std::string doc = isHere ? m_Docs.Of(CppType(type), member) : "";
        for (std::size_t at = doc.find('|'); at != std::string::npos; at = doc.find('|', at + 2))
        {
            doc.insert(at, "\\");
        }
        m_Documented += doc.empty() ? 0 : 1;
        return doc;
    }

    void ExpectInHeaders(const std::string& type, const std::string& member,
                         PortVerdict verdict) const
    {
        const bool isThere = m_Headers.Has(CppType(type), member);
        EXPECT_FALSE(verdict == PortVerdict::Same && !isThere)
            << type << "." << member << " is the 'same' in porting.txt, and not in the headers";
        EXPECT_FALSE(verdict == PortVerdict::Missing && isThere)
            << type << "." << member << " is 'missing' in porting.txt, and in the headers";
    }

    const HeaderWords m_Headers;
    const HeaderDocs m_Docs;
    std::string m_Table;
    std::string m_Details;
    Counts m_All{};
    int m_Types = 0;
    mutable int m_Documented = 0;
};

/// Compares with a file, or writes it where LIMN_UPDATE_GOLDEN says so.
void ExpectText(const std::string& path, const std::string& text)
{
    const std::string old = ReadText(path);
    if (std::getenv("LIMN_UPDATE_GOLDEN") != nullptr && old != text)
    {
        std::ofstream(path) << text;
        FAIL() << "wrote " << path;
    }
    EXPECT_EQ(text, old) << "LIMN_UPDATE_GOLDEN=1 writes it";
}

} // namespace

TEST(Coverage, IsTheOneOfTheTableAndOfTheDifferences)
{
    const std::vector<UnityType> types = ReadUnityTypes();
    ASSERT_GT(types.size(), 60u);
    const Coverage coverage(types);
    ExpectText(SourcePath("samples/porting/COVERAGE.md"), coverage.Document());
    const std::string path = SourcePath("samples/porting/DIFFERENCES.md");
    std::string page = ReadText(path);
    const std::size_t begin = page.find("Of the ", page.find("| Unity, C# | limn, C++ |"));
    ASSERT_NE(begin, std::string::npos);
    page.replace(begin, page.find('\n', begin) - begin, coverage.Sentence());
    ExpectText(path, page);
}

TEST(Coverage, TakesTheFirstSentenceOfAMembersDocLine)
{
    const HeaderDocs docs;
    EXPECT_EQ(docs.Of("CommandBuffer", "CopyTexture"), "Copies texel for texel");
    EXPECT_EQ(docs.Of("RenderTextureDescriptor", "useDynamicScale"),
              "no effect: nothing scales");                            // behind the member
    EXPECT_EQ(docs.Of("RasterCommandBuffer", "DrawRendererList"), ""); // a @throws alone
    EXPECT_EQ(docs.Of("UnsafeRenderGraphBuilder", "AllowPassCulling"),
              "Sets whether the pass may be culled."); // a base's
    EXPECT_EQ(docs.Of("CommandBuffer", "NoSuchMember"), "");
    EXPECT_GT(Coverage(ReadUnityTypes()).documented(), 200);
}

TEST(Coverage, ListsNoMemberTwice)
{
    for (const UnityType& type : ReadUnityTypes())
    {
        std::vector<std::string> members = type.members;
        std::ranges::sort(members);
        const auto twice = std::ranges::adjacent_find(members);
        if (twice != members.end())
        {
            ADD_FAILURE() << type.name << "." << *twice;
        }
    }
}

} // namespace limn::test
