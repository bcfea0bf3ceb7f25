#include "explain/InspectProfileFile.h"

#include "scene/ProfileContext.h"

#include <limn/volume/YamlMapReader.h>

namespace limn
{

namespace
{

using Names = std::set<std::string, std::less<>>;

/// Takes every name for a layer's and keeps those that are no layers of every project.
class AnySceneContext final : public SceneProfileContext
{
public:
    using SceneProfileContext::SceneProfileContext;

    std::optional<int> FindLayer(std::string_view name) const override
    {
        const std::optional<int> known = SceneProfileContext::FindLayer(name);
        if (!known)
        {
            m_SceneLayers.emplace(name);
        }
        return known.value_or(31);
    }

    const Names& sceneLayers() const { return m_SceneLayers; }

private:
    mutable Names m_SceneLayers;
};

/// One of the names that stands somewhere in the value; "" if none does.
std::string NameIn(const YamlNode& node, const Names& names)
{
    std::string found = node.isScalar() && names.count(node.scalar()) > 0 ? node.scalar() : "";
    for (const YamlNode& item : node.items())
    {
        found = found.empty() ? NameIn(item, names) : found;
    }
    for (const YamlEntry& entry : node.entries())
    {
        found = found.empty() ? NameIn(entry.value, names) : found;
    }
    return found;
}

/// The value on one line.
std::string AsWritten(const YamlNode& node)
{
    std::string list;
    for (const YamlNode& item : node.items())
    {
        list += (list.empty() ? "" : ", ") + AsWritten(item);
    }
    for (const YamlEntry& entry : node.entries())
    {
        list += (list.empty() ? "" : ", ") + entry.key + ": " + AsWritten(entry.value);
    }
    return node.isSequence() ? "[" + list + "]" : node.isMap() ? "{" + list + "}" : node.scalar();
}

const YamlNode* FindParameter(const YamlNode& component, const std::string& name)
{
    const YamlNode* node = component.Find(name);
    return node ? node : component.Find(PlainSpelling(name));
}

} // namespace

std::vector<InspectedGroup> InspectProfileFile(const std::filesystem::path& path,
                                               const std::vector<YamlNode>& documents,
                                               AssetContext& assets, Console& console)
{
    const LayerNames usual;
    const AnySceneContext context(assets, path, usual);
    const VolumeProfileLoadResult result =
        LoadVolumeProfile(path, assets.volumeComponents(), context);
    console.Print(result.notes);
    std::vector<InspectedGroup> groups = InspectProfile(*result.profile, assets.volumeComponents());
    for (InspectedGroup& group : groups)
    {
        const YamlNode* component = documents.front().Find(group.type);
        for (InspectedValue& value : group.values)
        {
            const YamlNode* node = component ? FindParameter(*component, value.name) : nullptr;
            const std::string layer = node ? NameIn(*node, context.sceneLayers()) : "";
            if (!layer.empty())
            {
                value.value = AsWritten(*node);
                console.Print(Diagnostic{Severity::Note, path.generic_string(), node->location(),
                                         group.type + "." + value.name +
                                             ": shown as written; only a scene can know the layer "
                                             "'" +
                                             layer + "'"});
            }
        }
    }
    return groups;
}

} // namespace limn
