#include <limn/volume/VolumeProfileLoader.h>

#include "yaml/Text.h"

#include <algorithm>
#include <cstdint>
#include <limn/base/HashContent.h>
#include <limn/base/Text.h>
#include <vector>

namespace limn
{

namespace
{

constexpr std::int64_t k_ProfileFileID = 11400000;

/// Text that YAML reads back as this text: as it is where that is safe, else in double quotes.
std::string Quoted(const std::string& text)
{
    const auto isWord = [](char c)
    {
        return isLetter(c) || isDigit(c);
    };
    const auto isPlain = [&](char c)
    {
        return isWord(c) || c == '-' || c == ' ' || c == '.';
    };
    const bool isNull = text == "null" || text == "Null" || text == "NULL";
    const bool isSafe = !text.empty() && isWord(text.front()) && text.back() != ' ' && !isNull &&
                        std::ranges::all_of(text, isPlain);
    return isSafe ? text : InQuotes(text, '"');
}

const std::string& NameOf(const VolumeComponent& component, const VolumeComponentRegistry& registry)
{
    const VolumeComponentRegistry::Entry* entry = registry.Find(typeid(component));
    if (!entry)
    {
        throw ContractError("a profile with a component whose type is not registered cannot be "
                            "written; register it under the name that files shall call it");
    }
    return entry->name;
}

std::string WriteLimn(const VolumeProfile& profile, const VolumeComponentRegistry& registry)
{
    std::string text;
    for (const std::unique_ptr<VolumeComponent>& component : profile.components())
    {
        std::string lines = component->active ? "" : "  active: false\n";
        for (const VolumeParameter* parameter : component->parameters())
        {
            if (parameter->overrideState())
            {
                lines += "  " + parameter->name() + ": " + parameter->ValueText() + "\n";
            }
        }
        text += Quoted(NameOf(*component, registry)) + (lines.empty() ? ": {}\n" : ":\n" + lines);
    }
    return text.empty() ? "{}\n" : text;
}

std::string HeaderText(std::int64_t fileID, int hideFlags, const std::string& name)
{
    return "--- !u!114 &" + std::to_string(fileID) +
           "\n"
           "MonoBehaviour:\n"
           "  m_ObjectHideFlags: " +
           std::to_string(hideFlags) +
           "\n"
           "  m_CorrespondingSourceObject: {fileID: 0}\n"
           "  m_PrefabInstance: {fileID: 0}\n"
           "  m_PrefabAsset: {fileID: 0}\n"
           "  m_GameObject: {fileID: 0}\n"
           "  m_Enabled: 1\n"
           "  m_EditorHideFlags: 0\n"
           "  m_Script: {fileID: 0}\n"
           "  m_Name: " +
           Quoted(name) +
           "\n"
           "  m_EditorClassIdentifier: \n";
}

std::string UnityComponent(const VolumeComponent& component, const std::string& name,
                           std::int64_t fileID)
{
    std::string text = HeaderText(fileID, 3, name);
    text += std::string("  active: ") + (component.active ? "1" : "0") + "\n";
    for (const VolumeParameter* parameter : component.parameters())
    {
        text += "  " + parameter->name() + ":\n";
        text += std::string("    m_OverrideState: ") + (parameter->overrideState() ? "1" : "0");
        text += "\n    m_Value: " + parameter->UnityText() + "\n";
    }
    return text;
}

/// The same for the same name wherever and whenever, and none of `used`.
std::int64_t FileIDOf(const std::string& name, const std::vector<std::int64_t>& used)
{
    auto fileID = static_cast<std::int64_t>(HashContent(name));
    while (fileID == 0 || fileID == k_ProfileFileID || std::ranges::count(used, fileID) > 0)
    {
        fileID = fileID / 2 + 1;
    }
    return fileID;
}

std::string WriteUnity(const VolumeProfile& profile, const VolumeComponentRegistry& registry)
{
    std::string text = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";
    std::vector<std::int64_t> fileIDs;
    for (const std::unique_ptr<VolumeComponent>& component : profile.components())
    {
        const std::string& name = NameOf(*component, registry);
        fileIDs.push_back(FileIDOf(name, fileIDs));
        text += UnityComponent(*component, name, fileIDs.back());
    }
    text += HeaderText(k_ProfileFileID, 0, profile.name);
    text += fileIDs.empty() ? "  components: []\n" : "  components:\n";
    for (const std::int64_t fileID : fileIDs)
    {
        text += "  - {fileID: " + std::to_string(fileID) + "}\n";
    }
    return text;
}

} // namespace

std::string WriteVolumeProfile(const VolumeProfile& profile,
                               const VolumeComponentRegistry& registry, YamlForm form)
{
    return form == YamlForm::Limn ? WriteLimn(profile, registry) : WriteUnity(profile, registry);
}

} // namespace limn
