#include "settings/ReadLayers.h"

#include "settings/Keys.h"

#include <algorithm>
#include <charconv>

namespace limn
{

namespace
{

bool LooksLikeNumber(const YamlNode& node)
{
    const std::string& text = node.scalar();
    const std::size_t sign = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
    return !node.isQuoted() && text.size() > sign &&
           text.find_first_not_of("0123456789", sign) == std::string::npos;
}

/// The number that a key of `layers` is; nothing unless it is 0...31.
std::optional<int> LayerNumber(std::string_view text)
{
    int number = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    const bool isNumber = error == std::errc{} && rest == end;
    return isNumber && number >= 0 && number <= 31 ? std::optional(number) : std::nullopt;
}

/// What is wrong with giving layer `index` this name; "" if nothing.
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
    if (const YamlNode* bits = node.Find("m_Bits"))
    {
        return ReadBits(*bits, std::string(subject) + ".m_Bits", diagnostics);
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
    for (std::size_t i = 0; i < m_Names.size(); ++i)
    {
        if (!name.empty() && m_Names[i] == name)
        {
            return static_cast<int>(i);
        }
    }
    return std::nullopt;
}

std::vector<std::string_view> LayerNames::names() const
{
    std::vector<std::string_view> names;
    for (const std::string& name : m_Names)
    {
        if (!name.empty())
        {
            names.push_back(name);
        }
    }
    return names;
}

} // namespace limn
