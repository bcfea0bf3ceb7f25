#include "port/Same.h"
#include "commands/CommandRun.h"
#include "port/PortingTable.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace limn::test
{

namespace
{

/// What the macros SAME hold, by row.
std::multimap<std::string, std::string> LinesInSource()
{
    static const std::regex k_Line(R"re(\bSAME\(\s*"([^"]+)",\s*([^;]+)\);)re");
    std::multimap<std::string, std::string> lines;
    for (const char* file : {"Commands", "Enums", "Frame", "Materials"})
    {
        const std::string text =
            ReadText(SourcePath("tests/editor_stub/port/Same" + std::string(file) + ".cpp"));
        using Iterator = std::sregex_iterator;
        for (Iterator line(text.begin(), text.end(), k_Line); line != Iterator(); ++line)
        {
            lines.emplace((*line)[1], (*line)[2]);
        }
    }
    return lines;
}

/// "Type.Member" of data/unity_members.txt, and the rows of the table: those that say "same".
std::set<std::string> SameRows()
{
    std::set<std::string> rows;
    for (const auto& [key, entry] : UnityPortingTable().entries())
    {
        if (entry.verdict == PortVerdict::Same && key.back() != '*')
        {
            rows.insert(key);
        }
    }
    std::istringstream lines(ReadText(SourcePath("tests/editor_stub/data/unity_members.txt")));
    std::string type;
    for (std::string line; std::getline(lines, line);)
    {
        if (line.empty() || line.front() == '#' || line.front() == '[')
        {
            continue;
        }
        if (line.front() != ' ')
        {
            type = line.substr(0, line.find(':'));
            line = line.substr(line.find(':') + 1);
        }
        std::istringstream words(line);
        for (std::string member; words >> member;)
        {
            const PortEntry* entry = UnityPortingTable().Find(type, member);
            if (entry != nullptr && entry->verdict == PortVerdict::Same)
            {
                rows.insert(type + "." + member);
            }
        }
    }
    return rows;
}

/// What C++ calls the last part of a row.
std::string WordOf(const std::string& row)
{
    const std::string word = row.substr(row.rfind('.') + 1);
    return word.size() > 1 && word[0] == 'I' && word.find("RenderGraphBuilder") != word.npos
               ? word.substr(1)
               : word;
}

} // namespace

TEST(Same, HasALineOfCppForEachRow)
{
    const auto lines = LinesInSource();
    const std::set<std::string> rows = SameRows();
    ASSERT_GT(rows.size(), 1000u);
    for (const std::string& row : rows)
    {
        EXPECT_TRUE(lines.contains(row))
            << row << " is the 'same' in porting.txt; write its line into a Same*.cpp";
    }
    for (const auto& [row, line] : lines)
    {
        EXPECT_TRUE(rows.contains(row)) << row << " is not the 'same' in porting.txt: " << line;
        EXPECT_TRUE(std::regex_search(line, std::regex("\\b" + WordOf(row) + "\\b")))
            << row << " is not in its line: " << line;
    }
}

} // namespace limn::test
