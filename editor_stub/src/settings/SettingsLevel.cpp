#include "settings/SettingsLevel.h"

#include <algorithm>
#include <limn/volume/UnityAsset.h>

namespace limn
{

namespace
{

/// Whether every MonoBehaviour's or every feature's block has the key.
bool IsBookkeeping(std::string_view key)
{
    return isUnityHeaderField(key) || key == "m_Active";
}

/// Whether the value is a reference, a vector or a colour: a map that is one value.
bool IsOneValue(const YamlNode& node)
{
    const auto isLetter = [](const YamlEntry& entry)
    {
        return entry.key.size() == 1;
    };
    return node.Find("fileID") || std::ranges::all_of(node.entries(), isLetter);
}

/// Whether an entry that is no member of the group is a settings class whose members are.
bool IsSettingsClass(const YamlEntry& entry, const SettingName& group)
{
    if (!entry.value.isMap() || IsOneValue(entry.value) || FindMember(group, entry.key))
    {
        return false;
    }
    return std::ranges::any_of(
        entry.value.entries(), [&group](const YamlEntry& inner)
        { return FindMember(group, inner.key) || IsSettingsClass(inner, group); });
}

const YamlEntry& EntryOf(const YamlMapReader& map, std::string_view name)
{
    return *std::ranges::find_if(map.node().entries(), [name](const YamlEntry& entry)
                                 { return entry.key == name || entry.key == PlainSpelling(name); });
}

} // namespace

SettingsLevel::SettingsLevel(const SettingName& group, std::string unityType,
                             AssetDiagnostics& diagnostics)
    : m_Group(group), m_UnityType(std::move(unityType)), m_Diagnostics(diagnostics)
{
}

void SettingsLevel::Add(YamlMapReader& map)
{
    m_Maps.push_back(&map);
    for (const YamlEntry& entry : map.node().entries())
    {
        if (IsSettingsClass(entry, m_Group))
        {
            const YamlNode& members = *map.Find(entry.key);
            Add(m_Own.emplace_back(members, map.SubjectOf(entry.key), m_Diagnostics, map.noun()));
        }
    }
}

void SettingsLevel::Add(const YamlNode& node, const YamlMapReader& outer)
{
    Add(m_Own.emplace_back(node, outer.SubjectOf(m_Group.name), m_Diagnostics, outer.noun()));
}

YamlMapReader* SettingsLevel::Find(std::string_view name)
{
    YamlMapReader* found = nullptr;
    for (YamlMapReader* map : m_Maps)
    {
        if (!map->Find(name)) // of each, so that each knows the name
        {
            continue;
        }
        if (found)
        {
            ReportTwice(name, *found, *map);
        }
        found = found ? found : map;
    }
    return found;
}

void SettingsLevel::ReportTwice(std::string_view name, const YamlMapReader& first,
                                const YamlMapReader& second)
{
    const SourceLocation before = EntryOf(first, name).keyLocation;
    const SourceLocation place = EntryOf(second, name).keyLocation;
    const std::string subject = second.SubjectOf(name);
    const std::string same = first.SubjectOf(name) + " at " + std::to_string(before.line) + ":" +
                             std::to_string(before.column);
    if (m_UnityType.empty())
    {
        m_Diagnostics.Error(place, subject + ": " + same + " is the same " + first.noun() +
                                       "; keep one of them");
        return;
    }
    m_Diagnostics.Note(place, subject + ": left out, " + m_UnityType +
                                  " has one setting of this name, which is " + same +
                                  "; a group in its Describe would tell them apart");
}

void SettingsLevel::NoteUnknown(const YamlMapReader& map)
{
    for (const YamlEntry& entry : map.node().entries())
    {
        const bool isKnown = IsBookkeeping(entry.key) || FindMember(m_Group, entry.key) ||
                             IsSettingsClass(entry, m_Group);
        if (!isKnown)
        {
            m_Diagnostics.Note(entry.keyLocation, map.SubjectOf(entry.key) + ": left out, " +
                                                      m_UnityType + " has no such setting");
        }
    }
}

void SettingsLevel::Finish(const SettingName& root)
{
    const std::vector<std::string> elsewhere = PathsOutside(root, m_Group);
    for (YamlMapReader* map : m_Maps)
    {
        if (m_UnityType.empty())
        {
            map->Finish(elsewhere);
        }
        else
        {
            NoteUnknown(*map);
        }
    }
}

} // namespace limn
