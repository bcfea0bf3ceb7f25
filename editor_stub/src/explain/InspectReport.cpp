#include "explain/InspectReport.h"
#include "console/Json.h"
#include "console/Texts.h"
#include "scene/ProfileContext.h"
#include "shader_reports/ShaderDescription.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limn/features/Features.h>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

namespace
{

std::string RangeText(const std::optional<ValueRange>& range)
{
    if (!range || (std::isinf(range->min) && std::isinf(range->max)))
    {
        return {};
    }
    const std::string low = std::isinf(range->min) ? "(-inf" : "[" + NumberText(range->min);
    return low + ", " + (std::isinf(range->max) ? "inf)" : NumberText(range->max) + "]");
}

/// The columns of a value's line.
std::vector<std::string> Columns(const InspectedValue& value)
{
    return {value.name,
            OneLine(value.value),
            value.hasDefault ? OneLine("default " + value.defaultValue) : "",
            RangeText(value.range),
            value.unit,
            value.isOverridden ? "set" : "",
            value.tooltip};
}

void AppendLine(std::string& text, const std::string& line)
{
    text += OneLine(line.substr(0, line.find_last_not_of(' ') + 1)) + "\n";
}

void AppendValues(std::string& text, const std::vector<InspectedValue>& values)
{
    std::vector<std::size_t> widths(Columns({}).size());
    for (const InspectedValue& value : values)
    {
        std::ranges::transform(widths, Columns(value), widths.begin(),
                               [](std::size_t width, const std::string& column)
                               { return std::max(width, column.size()); });
    }
    std::string header;
    for (const InspectedValue& value : values)
    {
        if (value.header != header)
        {
            header = value.header;
            AppendLine(text, "    " + header);
        }
        std::string line = header.empty() ? "    " : "      ";
        const std::vector<std::string> columns = Columns(value);
        for (std::size_t i = 0; i < columns.size(); ++i)
        {
            const bool isEmpty = widths[i] == 0;
            line += isEmpty ? "" : columns[i] + std::string(widths[i] - columns[i].size() + 2, ' ');
        }
        AppendLine(text, line);
    }
}

void AppendVolume(std::string& text, const InspectedVolume& volume)
{
    if (!volume.name.empty())
    {
        AppendLine(text, "volume '" + volume.name + "': " + (volume.enabled ? "" : "disabled, ") +
                             (volume.isGlobal
                                  ? "global"
                                  : "local, blendDistance " + NumberText(volume.blendDistance)) +
                             ", priority " + NumberText(volume.priority) + ", weight " +
                             NumberText(volume.weight) + ", profile '" + volume.profile + "'");
    }
    for (const InspectedGroup& component : volume.components)
    {
        AppendLine(text, "  " + component.type + (component.active ? "" : " (inactive)"));
        AppendValues(text, component.values);
    }
}

/// Numbers and truth values as such, everything else as text.
Json Typed(const std::string& text)
{
    const Json parsed = Json::parse(text, nullptr, false);
    return parsed.is_number() || parsed.is_boolean() ? parsed : Json(text);
}

/// null where there is no bound: JSON has no infinity.
Json Bound(double number)
{
    return std::isinf(number) ? Json(nullptr) : Json(number);
}

Json InspectedValueJson(const InspectedValue& value)
{
    Json json;
    json["name"] = value.name;
    json["value"] = Typed(value.value);
    if (value.hasDefault)
    {
        json["default"] = Typed(value.defaultValue);
        json["isSet"] = value.isOverridden;
    }
    if (value.range)
    {
        json["range"] = {Bound(value.range->min), Bound(value.range->max)};
    }
    for (const auto& [key, text] :
         {std::pair("header", &value.header), {"unit", &value.unit}, {"tooltip", &value.tooltip}})
    {
        if (!text->empty())
        {
            json[key] = *text;
        }
    }
    return json;
}

Json AsJson(const InspectedGroup& group, const char* valuesKey)
{
    Json json;
    json["type"] = group.type;
    if (!group.name.empty())
    {
        json["name"] = group.name;
    }
    json["active"] = group.active;
    json[valuesKey] = JsonList(group.values, InspectedValueJson);
    return json;
}

Json GroupsJson(const std::vector<InspectedGroup>& groups, const char* valuesKey)
{
    return JsonList(groups,
                    [valuesKey](const InspectedGroup& group) { return AsJson(group, valuesKey); });
}

Json InspectedVolumeJson(const InspectedVolume& volume)
{
    return {
        {"name", volume.name},         {"enabled", volume.enabled},
        {"isGlobal", volume.isGlobal}, {"priority", volume.priority},
        {"weight", volume.weight},     {"blendDistance", volume.blendDistance},
        {"profile", volume.profile},   {"components", GroupsJson(volume.components, "parameters")}};
}

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

/// Returns one of the names if it stands somewhere in the value, "" otherwise.
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

const YamlNode* FindParameter(const YamlNode& component, const std::string& name)
{
    const YamlNode* node = component.Find(name);
    return node ? node : component.Find(PlainSpelling(name));
}

constexpr std::array<std::string_view, 3> k_FeatureEndings{"", "RenderFeature", "RendererFeature"};

InspectedGroup InspectShader(const Shader& shader)
{
    InspectedGroup group;
    group.type = shader.name();
    for (const ShaderProperty& property : shader.document().properties)
    {
        InspectedValue& value = group.values.emplace_back();
        value.name = property.name;
        value.value = DefaultText(property);
        value.hasDefault = false;
        value.unit = TypeText(property);
        value.tooltip = property.displayName;
    }
    return group;
}

} // namespace

std::vector<InspectedGroup> InspectProfile(const VolumeProfile& profile,
                                           const VolumeComponentRegistry& registry)
{
    std::vector<InspectedGroup> groups;
    for (const auto& component : profile.components())
    {
        const VolumeComponent& reference = *component;
        const VolumeComponentRegistry::Entry* entry = registry.Find(typeid(reference));
        InspectedGroup& group = groups.emplace_back();
        group.type = entry->name;
        group.active = component->active;
        const std::span<const VolumeParameter* const> parameters = reference.parameters();
        for (std::size_t i = 0; i < parameters.size(); ++i)
        {
            InspectedValue& value = group.values.emplace_back();
            value.name = parameters[i]->name();
            value.value = parameters[i]->ValueText();
            value.defaultValue = entry->defaults->parameters()[i]->ValueText();
            value.range = parameters[i]->range();
            value.isOverridden = parameters[i]->overrideState();
            value.unit = parameters[i]->unit();
            value.tooltip = parameters[i]->tooltip();
        }
    }
    return groups;
}

std::vector<InspectedGroup> InspectFeatures(const RendererAsset& renderer,
                                            const FeatureRegistry& registry,
                                            const LayerNames& layers,
                                            const LayerNames& renderingLayers)
{
    std::vector<InspectedGroup> groups;
    for (std::size_t i = 0; i < renderer.features.size(); ++i)
    {
        ScriptableRendererFeature& feature = *renderer.features[i];
        const std::string& type = renderer.featureTypes[i];
        groups.push_back(
            {type, feature.name, feature.isActive(),
             CollectSettings(feature, *registry.Create(type), layers, renderingLayers)});
    }
    return groups;
}

std::string ToText(const InspectReport& report)
{
    std::string text;
    for (const InspectedVolume& volume : report.volumes)
    {
        AppendVolume(text, volume);
    }
    if (report.asset)
    {
        AppendLine(text, report.kind + " '" + report.asset->name + "': " + report.asset->type);
        AppendValues(text, report.asset->values);
    }
    for (const InspectedGroup& shader : report.shaders)
    {
        AppendLine(text, "shader '" + shader.type + "'");
        AppendValues(text, shader.values);
    }
    for (const InspectedGroup& feature : report.features)
    {
        AppendLine(text, "feature '" + feature.name + "': " + feature.type +
                             (feature.active ? "" : " (inactive)"));
        AppendValues(text, feature.values);
    }
    return text;
}

std::string ToJson(const InspectReport& report)
{
    Json json;
    json["kind"] = report.kind;
    const bool isName = report.kind == "name";
    if (isName || report.kind == "profile")
    {
        json["components"] = report.volumes.empty()
                                 ? Json::array()
                                 : GroupsJson(report.volumes.front().components, "parameters");
    }
    if (report.kind == "scene")
    {
        json["volumes"] = JsonList(report.volumes, InspectedVolumeJson);
    }
    if (report.asset)
    {
        json[report.kind] = AsJson(*report.asset, "values");
    }
    if (isName || report.kind == "scene" || report.kind == "renderer")
    {
        json["features"] = GroupsJson(report.features, "settings");
    }
    if (isName)
    {
        json["shaders"] = GroupsJson(report.shaders, "properties");
    }
    return JsonText(json);
}

std::string OnOneLine(const YamlNode& node)
{
    const std::string items = Joined(node.items(), ", ", OnOneLine);
    const std::string entries =
        Joined(node.entries(), ", ",
               [](const YamlEntry& entry) { return entry.key + ": " + OnOneLine(entry.value); });
    return node.isSequence() ? "[" + items + "]"
           : node.isMap()    ? "{" + entries + "}"
                             : node.scalar();
}

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
                value.value = OnOneLine(*node);
                console.Print(Diagnostic{
                    Severity::Note, path.generic_string(), node->location(),
                    group.type + "." + value.name +
                        ": the value is shown as it is written; only a scene knows the layer "
                        "'" +
                        layer + "'"});
            }
        }
    }
    return groups;
}

std::vector<std::string> KnownNames(const AssetContext& assets)
{
    std::vector<std::string> names;
    for (const auto& known : {assets.volumeComponents().names(), assets.features().names()})
    {
        names.insert(names.end(), known.begin(), known.end());
    }
    const auto shipped = ShippedShaders().names();
    names.insert(names.end(), shipped.begin(), shipped.end());
    return names;
}

InspectReport InspectName(const std::string& name, AssetContext& assets)
{
    InspectReport report;
    report.kind = "name";
    if (assets.volumeComponents().Find(name))
    {
        VolumeProfile profile;
        profile.Add(assets.volumeComponents().Create(name));
        report.volumes.emplace_back().components =
            InspectProfile(profile, assets.volumeComponents());
    }
    for (const std::string_view ending : k_FeatureEndings)
    {
        const std::string type = name + std::string(ending);
        if (std::unique_ptr<ScriptableRendererFeature> feature = assets.features().Create(type))
        {
            report.features.push_back({type, type, true,
                                       CollectSettings(*feature, *assets.features().Create(type),
                                                       LayerNames{}, LayerNames{})});
        }
    }
    if (const std::shared_ptr<const Shader> shader = assets.FindShader(name))
    {
        report.shaders.push_back(InspectShader(*shader));
    }
    if (report.volumes.empty() && report.features.empty() && report.shaders.empty())
    {
        const std::vector<std::string> known = KnownNames(assets);
        throw AssetError(name, {},
                         "there is no such file, and no volume component, feature or shader has "
                         "this name" +
                             DidYouMean(name, {known.begin(), known.end()}));
    }
    return report;
}

} // namespace limn
