#include "settings/ReadEnum.h"

#include <algorithm>
#include <charconv>

namespace limn
{

namespace
{

std::optional<int> ParseInt(std::string_view text)
{
    int value = 0;
    text.remove_prefix(!text.empty() && text.front() == '+' ? 1 : 0);
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && rest == end ? std::optional(value) : std::nullopt;
}

const EnumEntry* FindEntry(std::span<const EnumEntry> entries, std::string_view name)
{
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [name](const EnumEntry& entry) { return entry.name == name; });
    return found == entries.end() ? nullptr : &*found;
}

void RefuseName(const YamlNode& node, std::string_view name, std::span<const EnumEntry> entries,
                std::string_view subject, AssetDiagnostics& diagnostics)
{
    std::vector<std::string_view> names;
    for (const EnumEntry& entry : entries)
    {
        names.push_back(entry.name);
    }
    diagnostics.Error(node.location(),
                      std::string(subject) + ": unknown value " + UnknownName(name, names));
}

std::string WithNumbers(std::span<const EnumEntry> entries)
{
    std::string text;
    for (const EnumEntry& entry : entries)
    {
        text += (text.empty() ? "" : ", ") + std::string(entry.name) + " " +
                std::to_string(entry.value);
    }
    return text;
}

} // namespace

std::optional<int> ReadEnum(const YamlNode& node, std::span<const EnumEntry> entries,
                            std::string_view subject, AssetDiagnostics& diagnostics)
{
    const std::optional<std::string> text = ReadString(node, subject, diagnostics);
    if (!text)
    {
        return std::nullopt;
    }
    if (const EnumEntry* entry = FindEntry(entries, *text))
    {
        return entry->value;
    }
    const std::optional<int> number = ParseInt(*text);
    if (!number)
    {
        RefuseName(node, *text, entries, subject, diagnostics);
        return std::nullopt;
    }
    const bool isMember =
        std::any_of(entries.begin(), entries.end(),
                    [&number](const EnumEntry& entry) { return entry.value == *number; });
    if (!isMember)
    {
        diagnostics.Error(node.location(), std::string(subject) + ": " + *text + " is none of " +
                                               WithNumbers(entries));
        return std::nullopt;
    }
    return number;
}

std::optional<RenderPassEvent> ReadRenderPassEvent(const YamlNode& node, std::string_view subject,
                                                   AssetDiagnostics& diagnostics)
{
    std::optional<std::string> text = ReadString(node, subject, diagnostics);
    if (!text)
    {
        return std::nullopt;
    }
    if (const std::optional<int> number = ParseInt(*text))
    {
        return static_cast<RenderPassEvent>(*number);
    }
    std::erase(*text, ' ');
    const std::size_t split = std::min(text->find_first_of("+-"), text->size());
    const std::string name = text->substr(0, split);
    const EnumEntry* entry = FindEntry(RenderPassEventEntries(), name);
    const std::optional<int> distance =
        split == text->size() ? std::optional(0) : ParseInt(std::string_view(*text).substr(split));
    if (!entry)
    {
        RefuseName(node, name, RenderPassEventEntries(), subject, diagnostics);
        return std::nullopt;
    }
    if (!distance)
    {
        diagnostics.Error(node.location(), std::string(subject) + ": '" + text->substr(split) +
                                               "' is no distance from " + name +
                                               "; a whole number is expected, " + name + "+1");
        return std::nullopt;
    }
    return static_cast<RenderPassEvent>(entry->value + *distance);
}

} // namespace limn
