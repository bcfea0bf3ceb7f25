#include <limn/volume/YamlMapReader.h>

#include <algorithm>
#include <limn/base/Case.h>

namespace limn
{

namespace
{

bool HasSerializedPrefix(std::string_view name)
{
    return name.size() > 2 && name.starts_with("m_");
}

/// "width" of "settings.width".
std::string_view LastName(std::string_view path)
{
    return path.substr(path.rfind('.') + 1);
}

/// The unknown key, and the nearest known one: of this map unless another has its very name.
std::string UnknownKey(std::string_view key, const std::vector<std::string>& names,
                       std::span<const std::string> elsewhere)
{
    const auto isIts = [key](const std::string& path)
    {
        return LastName(path) == key || PlainSpelling(LastName(path)) == key;
    };
    const auto isNear = [key](const std::string& path)
    {
        const std::string plain = PlainSpelling(LastName(path));
        return !NearestName(key, {LastName(path), plain}).empty();
    };
    const std::vector<std::string_view> views(names.begin(), names.end());
    auto other = std::ranges::find_if(elsewhere, isIts);
    if (other == elsewhere.end() && NearestName(key, views).empty())
    {
        other = std::ranges::find_if(elsewhere, isNear);
    }
    if (other == elsewhere.end())
    {
        return UnknownName(key, views);
    }
    const bool isTop = other->find('.') == std::string::npos;
    return "'" + std::string(key) + "'; " +
           (isTop ? "'" + *other + "' stands outside of all groups"
                  : "did you mean '" + *other + "'?");
}

} // namespace

std::string PlainSpelling(std::string_view serializedName)
{
    if (!HasSerializedPrefix(serializedName))
    {
        return std::string(serializedName);
    }
    std::string plain(serializedName.substr(2));
    plain.front() = ToLower(plain.front());
    return plain;
}

YamlMapReader::YamlMapReader(YamlNode node, std::string subject, AssetDiagnostics& diagnostics,
                             std::string noun)
    : m_Node(std::move(node)),
      m_Subject(std::move(subject)),
      m_Noun(std::move(noun)),
      m_Diagnostics(diagnostics)
{
    if (!m_Node.isMap() && !m_Node.isNull())
    {
        m_Diagnostics.Error(m_Node.location(), m_Subject + ": found " + m_Node.Describe() +
                                                   "; a map with one '" + m_Noun +
                                                   ": value' per line is expected");
    }
}

const YamlNode* YamlMapReader::Find(std::string_view key)
{
    const std::string plain = PlainSpelling(key);
    const bool isNew = std::find(m_Known.begin(), m_Known.end(), key) == m_Known.end();
    const YamlEntry* found = nullptr;
    for (const YamlEntry& entry : m_Node.entries())
    {
        if (entry.key != key && entry.key != plain)
        {
            continue;
        }
        if (found && isNew)
        {
            ReportTwice(*found, entry);
        }
        found = found ? found : &entry;
    }
    if (isNew)
    {
        m_Known.emplace_back(key);
    }
    return found ? &found->value : nullptr;
}

const YamlNode* YamlMapReader::Require(std::string_view key)
{
    const YamlNode* node = Find(key);
    if (!node && (m_Node.isMap() || m_Node.isNull()))
    {
        m_Diagnostics.Error(m_Node.location(),
                            m_Subject + ": " + m_Noun + " '" + PlainSpelling(key) + "' is missing");
    }
    return node;
}

void YamlMapReader::ReportTwice(const YamlEntry& first, const YamlEntry& second)
{
    m_Diagnostics.Error(second.keyLocation,
                        m_Subject + ": '" + second.key + "' is the same " + m_Noun + " as '" +
                            first.key + "' at " + std::to_string(first.keyLocation.line) + ":" +
                            std::to_string(first.keyLocation.column) + "; keep one of them");
}

void YamlMapReader::Finish(std::span<const std::string> elsewhere)
{
    for (const YamlEntry& entry : m_Node.entries())
    {
        // Suggestions come in the spelling that the writer uses.
        const bool isSerialized = HasSerializedPrefix(entry.key);
        bool isKnown = false;
        std::vector<std::string> names;
        for (const std::string& known : m_Known)
        {
            const std::string plain = PlainSpelling(known);
            isKnown = isKnown || entry.key == known || entry.key == plain;
            names.push_back(isSerialized ? known : plain);
        }
        if (!isKnown)
        {
            m_Diagnostics.Error(entry.keyLocation, m_Subject + ": unknown " + m_Noun + " " +
                                                       UnknownKey(entry.key, names, elsewhere));
        }
    }
}

std::string YamlMapReader::SubjectOf(std::string_view key) const
{
    return m_Subject + (m_Subject.empty() ? "" : ".") + std::string(key);
}

} // namespace limn
