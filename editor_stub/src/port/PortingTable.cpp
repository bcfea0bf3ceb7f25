#include "port/PortingTable.h"

#include "console/Texts.h"

#include <algorithm>
#include <array>
#include <limn/base/Diagnostic.h>
#include <limn/base/EmbeddedFile.h>
#include <limn/base/WordList.h>

namespace limn
{

namespace embedded
{
std::span<const EmbeddedFile> PortingTableText();
}

namespace
{

constexpr std::array<std::string_view, 4> k_Verdicts{"same", "differs", "refused", "missing"};

[[noreturn]] void Fail(int line, const std::string& message)
{
    throw ContractError("porting.txt:" + std::to_string(line) + ": " + message);
}

/// "{A,B}.{c,d}>T" → A.c>T, A.d>T, B.c>T, B.d>T; what stands inside may have its own >T.
std::vector<std::string> Expand(const std::string& key)
{
    const std::size_t open = key.find('{');
    if (open == std::string::npos)
    {
        return {key};
    }
    const std::size_t close = key.find('}', open);
    std::vector<std::string> keys;
    for (const std::string& part : SplitText(key.substr(open + 1, close - open - 1), ','))
    {
        for (std::string& expanded : Expand(key.substr(0, open) + part + key.substr(close + 1)))
        {
            keys.push_back(std::move(expanded));
        }
    }
    return keys;
}

/// "| a | b |" → "a → b"
std::string RowWords(std::string_view row)
{
    const std::size_t middle = row.find(" | ");
    return std::string(row.substr(2, middle - 2)) + " → " +
           std::string(row.substr(middle + 3, row.size() - middle - 5));
}

} // namespace

const char* ToString(PortVerdict verdict)
{
    return k_Verdicts.at(static_cast<std::size_t>(verdict)).data();
}

PortingTable::PortingTable(std::string_view text)
{
    std::string rowWords;
    int number = 0;
    for (const std::string& line : SplitText(std::string(text), '\n'))
    {
        ++number;
        if (line.empty())
        {
            rowWords.clear();
        }
        else if (line.front() == '|')
        {
            if (line.find(" | ") == std::string::npos || !line.ends_with(" |"))
            {
                Fail(number, "'| Unity | limn |' is expected");
            }
            m_Rows.push_back(line);
            rowWords = RowWords(line);
        }
        else if (line.front() != '#')
        {
            ReadVerdict(line, rowWords, number);
        }
    }
}

void PortingTable::ReadVerdict(std::string_view line, const std::string& rowWords, int number)
{
    const std::size_t colon = line.find(" : ");
    const bool hasWords = colon != std::string_view::npos;
    const std::vector<std::string_view> words = SplitWords(line.substr(0, colon));
    const auto verdict = std::ranges::find(k_Verdicts, words.front()) - k_Verdicts.begin();
    if (verdict == std::ssize(k_Verdicts) || words.size() < 2)
    {
        Fail(number, "same, differs, refused or missing, and a name are expected");
    }
    PortEntry entry;
    entry.verdict = static_cast<PortVerdict>(verdict);
    entry.words = hasWords                             ? std::string(line.substr(colon + 3))
                  : entry.verdict == PortVerdict::Same ? ""
                                                       : rowWords;
    if (entry.words.empty() && entry.verdict == PortVerdict::Differs)
    {
        Fail(number, "how it differs is expected behind ' : '");
    }
    for (std::size_t i = 1; i < words.size(); ++i)
    {
        for (const std::string& key : Expand(std::string(words[i])))
        {
            Add(key, entry, number);
        }
    }
}

void PortingTable::Add(const std::string& key, const PortEntry& entry, int number)
{
    const std::size_t arrow = key.find('>');
    PortEntry& added = m_Entries[key.substr(0, arrow)];
    if (!added.words.empty() || added.verdict != PortVerdict::Same || !added.result.empty())
    {
        Fail(number, "'" + key + "' stands in two rows; keep one of them");
    }
    added = entry;
    added.result = arrow == std::string::npos ? "" : key.substr(arrow + 1);
}

const PortEntry* PortingTable::Find(std::string_view key) const
{
    const auto found = m_Entries.find(key);
    return found == m_Entries.end() ? nullptr : &found->second;
}

const PortEntry* PortingTable::Find(std::string_view type, std::string_view member) const
{
    const PortEntry* entry = Find(std::string(type) + "." + std::string(member));
    return entry ? entry : Find(std::string(type) + ".*");
}

bool PortingTable::HasType(std::string_view type) const
{
    const auto member = m_Entries.lower_bound(std::string(type) + ".");
    return Find(type) ||
           (member != m_Entries.end() && member->first.starts_with(std::string(type) + "."));
}

const PortingTable& UnityPortingTable()
{
    static const PortingTable table(embedded::PortingTableText().front().text);
    return table;
}

} // namespace limn
