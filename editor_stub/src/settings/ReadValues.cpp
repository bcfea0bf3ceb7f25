#include "settings/ReadValues.h"

#include "console/Texts.h"
#include "settings/Keys.h"

#include <algorithm>
#include <limn/base/ParseWhole.h>

namespace limn
{

namespace
{

/// The number that a key of `layers` is; nothing unless it is 0...31.
std::optional<int> LayerNumber(std::string_view text)
{
    const std::optional<int> number = ParseWhole<int>(text);
    return number >= 0 && number <= 31 ? number : std::nullopt;
}

/// Returns why layer `index` cannot have this name, "" if it can.
std::string NameProblem(int index, const std::string& name, const LayerNames& names)
{
    if (name.empty() || name == "Everything" || name == "Nothing")
    {
        return "'" + name + "' cannot be a layer's name; masks use it for something else";
    }
    const std::optional<int> owner = names.Find(name);
    if (owner && *owner != index)
    {
        return "'" + name + "' is the name of layer " + std::to_string(*owner) +
               " already; a name belongs to one layer";
    }
    if (index == 0 && name != "Default")
    {
        return "layer 0 is always 'Default'; name one of 1...31";
    }
    return {};
}

std::optional<std::uint32_t> ReadListOfLayers(const YamlNode& node, std::string_view subject,
                                              const LayerKind& kind, AssetDiagnostics& diagnostics)
{
    std::uint32_t bits = 0;
    bool isGood = true;
    for (std::size_t i = 0; i < node.items().size(); ++i)
    {
        const std::string item = std::string(subject) + "[" + std::to_string(i) + "]";
        const std::optional<int> index = ReadLayerIndex(node.items()[i], item, kind, diagnostics);
        isGood = isGood && index.has_value();
        bits |= index ? std::uint32_t{1} << *index : 0;
    }
    return isGood ? std::optional(bits) : std::nullopt;
}

std::optional<std::uint32_t> ReadBits(const YamlNode& node, std::string_view subject,
                                      AssetDiagnostics& diagnostics)
{
    const auto bits = ReadInteger(node, subject, diagnostics, k_LayerBits);
    return bits ? std::optional(static_cast<std::uint32_t>(*bits)) : std::nullopt;
}

std::optional<int> ParseInt(std::string_view text)
{
    return ParseWhole<int>(text.substr(text.starts_with('+') ? 1 : 0));
}

const EnumEntry* FindEntry(std::span<const EnumEntry> entries, std::string_view name)
{
    const auto found = std::ranges::find(entries, name, &EnumEntry::name);
    return found == entries.end() ? nullptr : &*found;
}

void RefuseName(const YamlNode& node, std::string_view name, std::span<const EnumEntry> entries,
                std::string_view subject, AssetDiagnostics& diagnostics)
{
    diagnostics.Error(node.location(), std::string(subject) + ": unknown value " +
                                           UnknownName(name, NamesOf(entries, &EnumEntry::name)));
}

std::string WithNumber(const EnumEntry& entry)
{
    return std::string(entry.name) + " " + std::to_string(entry.value);
}

/// Returns m_Bits, or the one number that a project's own struct for a mask has. Null if the node
/// is neither.
const YamlEntry* FindBits(const YamlNode& node)
{
    const auto found = std::ranges::find(node.entries(), "m_Bits", &YamlEntry::key);
    if (found != node.entries().end())
    {
        return &*found;
    }
    return node.entries().size() == 1 && LooksLikeNumber(node.entries()[0].value)
               ? node.entries().data()
               : nullptr;
}

} // namespace

void ReadLayerNames(const YamlNode& node, std::string_view subject, LayerNames& names,
                    AssetDiagnostics& diagnostics)
{
    const std::string prefix(subject);
    if (!node.isMap() && !node.isNull())
    {
        diagnostics.Error(node.location(), prefix + ": found " + node.Describe() +
                                               "; numbers with names are expected: {6: Furniture}");
    }
    for (const YamlEntry& entry : node.entries())
    {
        const std::string item = prefix + "." + entry.key;
        const std::optional<int> index = LayerNumber(entry.key);
        if (!index)
        {
            diagnostics.Error(entry.keyLocation,
                              item +
                                  ": a layer's number is expected, 0...31, and its name behind it");
            continue;
        }
        const std::string name = ReadString(entry.value, item, diagnostics).value_or("Default");
        const std::string problem =
            entry.value.isScalar() ? NameProblem(*index, name, names) : std::string();
        if (!problem.empty())
        {
            diagnostics.Error(entry.value.location(), item + ": " + problem);
            continue;
        }
        names.SetName(*index, entry.value.isScalar() ? name : std::string());
    }
}

std::optional<int> ReadLayerIndex(const YamlNode& node, std::string_view subject,
                                  const LayerKind& kind, AssetDiagnostics& diagnostics)
{
    if (LooksLikeNumber(node))
    {
        return ReadInt(node, subject, diagnostics, k_LayerIndices);
    }
    const std::optional<std::string> name = ReadString(node, subject, diagnostics);
    if (!name)
    {
        return std::nullopt;
    }
    const std::optional<int> index = kind.names.Find(*name);
    if (!index)
    {
        diagnostics.Error(node.location(), std::string(subject) + ": unknown " + kind.noun + " " +
                                               UnknownName(*name, kind.names.names()));
    }
    return index;
}

std::optional<std::uint32_t> ReadLayerBits(const YamlNode& node, std::string_view subject,
                                           const LayerKind& kind, AssetDiagnostics& diagnostics)
{
    if (const YamlEntry* bits = FindBits(node))
    {
        return ReadBits(bits->value, std::string(subject) + "." + bits->key, diagnostics);
    }
    if (node.isSequence())
    {
        return ReadListOfLayers(node, subject, kind, diagnostics);
    }
    if (LooksLikeNumber(node))
    {
        return ReadBits(node, subject, diagnostics);
    }
    if (node.scalar() == "Everything")
    {
        return static_cast<std::uint32_t>(k_LayerBits.max);
    }
    if (node.scalar() == "Nothing")
    {
        return 0u;
    }
    const std::optional<int> index = ReadLayerIndex(node, subject, kind, diagnostics);
    return index ? std::optional(std::uint32_t{1} << *index) : std::nullopt;
}

std::optional<int> LayerNames::Find(std::string_view name) const
{
    const auto found = std::ranges::find(m_Names, name);
    return name.empty() || found == m_Names.end()
               ? std::nullopt
               : std::optional(static_cast<int>(found - m_Names.begin()));
}

std::vector<std::string_view> LayerNames::names() const
{
    std::vector<std::string_view> names;
    std::ranges::copy_if(m_Names, std::back_inserter(names),
                         [](const std::string& name) { return !name.empty(); });
    return names;
}

std::optional<int> ReadEnum(const YamlNode& node, std::span<const EnumEntry> entries,
                            std::string_view subject, AssetDiagnostics& diagnostics)
{
    const EnumEntry* everything = FindEntry(entries, "Everything");
    if (everything != nullptr && node.isSequence())
    {
        std::optional<int> bits = 0;
        for (const YamlNode& item : node.items())
        {
            const std::optional<int> bit = ReadEnum(item, entries, subject, diagnostics);
            bits = bits && bit ? std::optional(*bits | *bit) : std::nullopt;
        }
        return bits;
    }
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
    if (everything != nullptr && (*number == -1 || (*number & ~everything->value) == 0))
    {
        return *number & everything->value;
    }
    if (std::ranges::find(entries, *number, &EnumEntry::value) == entries.end())
    {
        diagnostics.Error(node.location(), std::string(subject) + ": " + *text + " is none of " +
                                               Joined(entries, ", ", WithNumber));
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
