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

std::string_view BaseOf(std::string_view type)
{
    if (IsIn(type, {"Texture2D", "Texture3D", "Cubemap", "RenderTexture"}))
    {
        return "Texture";
    }
    if (IsIn(type, {"Material", "Shader", "Texture", "Mesh", "GameObject",
                    "ScriptableRendererFeature", "VolumeComponent"}))
    {
        return "Object";
    }
    if (type == "UniversalRenderer")
    {
        return "ScriptableRenderer";
    }
    return type.ends_with("Parameter") && type != "VolumeParameter" ? "VolumeParameter" : "";
}

/// Takes the result over from a key with ">T".
void SetResult(const std::string& key, PortEntry& entry)
{
    const std::size_t arrow = key.find('>');
    if (arrow != std::string::npos)
    {
        entry.isPointer = key.ends_with('*');
        entry.result = key.substr(arrow + 1, key.size() - arrow - (entry.isPointer ? 2 : 1));
    }
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
        else if (SplitWords(line).front() == "cpp")
        {
            ReadCode(line, number);
        }
        else if (SplitWords(line).front() == "names")
        {
            ReadParameters(line, number);
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

void PortingTable::ReadCode(std::string_view line, int number)
{
    const std::size_t equals = std::min(line.find(" = "), line.find(" := "));
    if (equals == std::string_view::npos)
    {
        Fail(number, "' = ' and the member in C++ are expected, or ' := ' and an assignment to it");
    }
    const bool isSet = line[equals + 1] == ':';
    const std::vector<std::string_view> words = SplitWords(line.substr(0, equals));
    for (std::size_t i = 1; i < words.size(); ++i)
    {
        for (const std::string& key : Expand(std::string(words[i])))
        {
            const std::string code(line.substr(equals + (isSet ? 4 : 3)));
            if (key.starts_with("new:") || key.find('/') != std::string::npos)
            {
                m_Codes[key] = code;
                continue;
            }
            const std::size_t arrow = key.find('>');
            const auto entry = m_Entries.find(key.substr(0, arrow));
            if (entry == m_Entries.end())
            {
                Fail(number, "'" + key + "' has no verdict above");
            }
            (isSet ? entry->second.cppSet : entry->second.cpp) = code;
            SetResult(key, entry->second);
        }
    }
}

void PortingTable::ReadParameters(std::string_view line, int number)
{
    const std::vector<std::string_view> words = SplitWords(line);
    if (words.size() < 4 || words[2] != "=")
    {
        Fail(number, "'names KEY = PARAMETER ...' is expected");
    }
    std::vector<PortParameter>& parameters = m_Parameters[std::string(words[1])];
    for (std::size_t i = 3; i < words.size(); ++i)
    {
        const std::size_t equals = std::min(words[i].find('='), words[i].size());
        const std::string_view otherwise = words[i].substr(std::min(equals + 1, words[i].size()));
        parameters.push_back({std::string(words[i].substr(0, equals)), std::string(otherwise)});
    }
}

std::vector<PortParameter> PortingTable::ParametersOf(std::string_view key) const
{
    const auto found = m_Parameters.find(key);
    return found == m_Parameters.end() ? std::vector<PortParameter>() : found->second;
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
    SetResult(key, added);
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

std::string PortingTable::CodeFor(const std::string& key, std::size_t arguments) const
{
    const auto special = m_Codes.find(key + "/" + std::to_string(arguments));
    const auto any = m_Codes.find(key);
    return special != m_Codes.end() ? special->second : any != m_Codes.end() ? any->second : "";
}

std::string PortingTable::OwnerOf(std::string_view type, std::string_view member,
                                  bool isExact) const
{
    for (std::string_view at = type; !at.empty(); at = BaseOf(at))
    {
        const bool isThere = isExact ? Find(std::string(at) + "." + std::string(member)) != nullptr
                                     : Find(at, member) != nullptr;
        if (isThere)
        {
            return std::string(at);
        }
    }
    return "";
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
