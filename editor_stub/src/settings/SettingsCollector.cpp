#include "settings/SettingsCollector.h"

#include "console/Texts.h"
#include "plugins/LoadPlugin.h"

#include <limn/core/ComputeShader.h>
#include <limn/core/Material.h>

namespace limn
{

namespace
{

template <typename Tag>
std::string Text(detail::BitMask32<Tag> mask, const LayerNames& layers)
{
    if (mask.bits == 0 || mask == mask.Everything())
    {
        return mask.bits == 0 ? "Nothing" : "Everything";
    }
    std::string list;
    for (int index = 0; index < 32; ++index)
    {
        if (((mask.bits >> index) & 1u) != 0)
        {
            const std::string& name = layers.Name(index);
            list += (list.empty() ? "" : ", ") + (name.empty() ? std::to_string(index) : name);
        }
    }
    return "[" + list + "]";
}

/// The last named event that is not later, and how far behind it the event is.
std::string Text(RenderPassEvent event)
{
    const int number = static_cast<int>(event);
    const std::span<const EnumEntry> entries = RenderPassEventEntries(); // by ascending value
    const auto later = std::ranges::upper_bound(entries, number, {}, &EnumEntry::value);
    if (later == entries.begin())
    {
        return std::to_string(number);
    }
    const EnumEntry& nearest = *(later - 1);
    const int distance = number - nearest.value;
    return std::string(nearest.name) + (distance > 0 ? " + " + std::to_string(distance) : "");
}

/// A setting's value as text for people.
struct ValueText
{
    const LayerNames& layers;
    const LayerNames& renderingLayers;

    std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
    std::string operator()(const int* value) const { return std::to_string(*value); }
    std::string operator()(const std::uint32_t* value) const { return std::to_string(*value); }
    std::string operator()(const float* value) const { return NumberText(*value); }
    std::string operator()(const std::string* value) const { return *value; }
    std::string operator()(const Color* value) const { return MembersText(&value->r, "rgba"); }
    std::string operator()(const glm::vec2* value) const { return MembersText(&value->x, "xy"); }
    std::string operator()(const glm::vec3* value) const { return MembersText(&value->x, "xyz"); }
    std::string operator()(const glm::vec4* value) const { return MembersText(&value->x, "xyzw"); }
    std::string operator()(const LayerMask* value) const { return Text(*value, layers); }
    std::string operator()(const RenderingLayerMask* value) const
    {
        return Text(*value, renderingLayers);
    }
    std::string operator()(const RenderPassEvent* value) const { return Text(*value); }
    std::string operator()(const std::vector<std::string>* value) const
    {
        return "[" + Joined(*value, ", ") + "]";
    }
    template <typename Asset>
    std::string operator()(const std::shared_ptr<const Asset>* value) const
    {
        return *value ? (*value)->name() : "none";
    }
    std::string operator()(EnumValue value) const
    {
        std::vector<std::string_view> parts;
        for (const EnumEntry& entry : value.entries)
        {
            if (entry.value == value.value)
            {
                return std::string(entry.name);
            }
            if (entry.value != 0 && (entry.value & value.value) == entry.value)
            {
                parts.push_back(entry.name);
            }
        }
        const bool isSet =
            std::ranges::find(value.entries, "Everything", &EnumEntry::name) != value.entries.end();
        return isSet ? "[" + Joined(parts, ", ") + "]" : std::to_string(value.value);
    }
    std::string operator()(RenderingLayerValue value) const
    {
        const std::string& layer = renderingLayers.Name(value.value);
        return layer.empty() ? std::to_string(value.value) : layer;
    }
};

class SettingsCollector final : public Inspector
{
public:
    SettingsCollector(const LayerNames& layers, const LayerNames& renderingLayers)
        : m_Text{layers, renderingLayers}
    {
    }

    void Header(std::string_view text) override { m_Header = text; }
    void BeginGroup(std::string_view name) override { m_Groups.emplace_back(name); }
    void EndGroup() override { m_Groups.pop_back(); }
    void Field(const FieldInfo& field, FieldValue value) override
    {
        InspectedValue& result = values.emplace_back();
        result.header = m_Header;
        for (const std::string& group : m_Groups)
        {
            result.name += group + ".";
        }
        result.name += field.name;
        result.value = std::visit(m_Text, value);
        result.range = field.range;
        result.tooltip = field.tooltip;
    }

    std::vector<InspectedValue> values;

private:
    ValueText m_Text;
    std::string m_Header;
    std::vector<std::string> m_Groups; ///< that the fields are in now, the outermost first
};

} // namespace

std::string MembersText(const float* numbers, std::string_view names)
{
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        text += (i == 0 ? "{" : ", ") + std::string(1, names[i]) + ": " +
                NumberText(static_cast<double>(numbers[i]));
    }
    return text + "}";
}

std::vector<InspectedValue> CollectSettings(ScriptableRendererFeature& feature,
                                            ScriptableRendererFeature& defaultFeature,
                                            const LayerNames& layers,
                                            const LayerNames& renderingLayers)
{
    SettingsCollector collector(layers, renderingLayers);
    DescribeFeature(feature, collector);
    SettingsCollector defaults(layers, renderingLayers);
    DescribeFeature(defaultFeature, defaults);
    for (std::size_t i = 0; i < collector.values.size(); ++i)
    {
        InspectedValue& value = collector.values[i];
        value.defaultValue = defaults.values.at(i).value;
        value.isOverridden = value.value != value.defaultValue;
    }
    return std::move(collector.values);
}

} // namespace limn
