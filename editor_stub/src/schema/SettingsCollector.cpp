#include "schema/SettingsCollector.h"

#include <limn/core/Material.h>

namespace limn
{

namespace
{

std::string Text(LayerMask mask, const LayerNames& layers)
{
    if (mask.bits == 0 || mask == LayerMask::Everything())
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
    const EnumEntry* nearest = nullptr;
    for (const EnumEntry& entry : RenderPassEventEntries())
    {
        if (entry.value <= number && (!nearest || entry.value > nearest->value))
        {
            nearest = &entry;
        }
    }
    if (!nearest)
    {
        return std::to_string(number);
    }
    const int distance = number - nearest->value;
    return std::string(nearest->name) + (distance > 0 ? " + " + std::to_string(distance) : "");
}

class SettingsCollector final : public Inspector
{
public:
    SettingsCollector(const LayerNames& layers, const LayerNames& renderingLayers)
        : m_Layers(layers), m_RenderingLayers(renderingLayers)
    {
    }

    void Header(std::string_view text) override { m_Header = text; }
    void Field(std::string_view name, bool& value, std::string_view tooltip) override
    {
        Add(name, value ? "true" : "false", tooltip);
    }
    void Field(std::string_view name, int& value, FieldRange range,
               std::string_view tooltip) override
    {
        Add(name, std::to_string(value), tooltip, ValueRange{range.minimum, range.maximum});
    }
    void Field(std::string_view name, float& value, FieldRange range,
               std::string_view tooltip) override
    {
        Add(name, NumberText(value), tooltip, ValueRange{range.minimum, range.maximum});
    }
    void Field(std::string_view name, Color& value, std::string_view tooltip) override
    {
        Add(name,
            "{r: " + NumberText(value.r) + ", g: " + NumberText(value.g) +
                ", b: " + NumberText(value.b) + ", a: " + NumberText(value.a) + "}",
            tooltip);
    }
    void Field(std::string_view name, LayerMask& value, std::string_view tooltip) override
    {
        Add(name, Text(value, m_Layers), tooltip);
    }
    void Field(std::string_view name, RenderPassEvent& value, std::string_view tooltip) override
    {
        Add(name, Text(value), tooltip);
    }
    void Field(std::string_view name, std::shared_ptr<const Shader>& value,
               std::string_view tooltip) override
    {
        Add(name, value ? value->name() : "none", tooltip);
    }
    void Field(std::string_view name, std::shared_ptr<const Material>& value,
               std::string_view tooltip) override
    {
        Add(name, value ? value->name() : "none", tooltip);
    }
    void Field(std::string_view name, glm::vec4& value, std::string_view tooltip) override
    {
        Add(name,
            "{x: " + NumberText(value.x) + ", y: " + NumberText(value.y) +
                ", z: " + NumberText(value.z) + ", w: " + NumberText(value.w) + "}",
            tooltip);
    }
    void Field(std::string_view name, std::string& value, std::string_view tooltip) override
    {
        Add(name, value, tooltip);
    }
    void Field(std::string_view name, std::vector<std::string>& value,
               std::string_view tooltip) override
    {
        std::string list;
        for (const std::string& item : value)
        {
            list += (list.empty() ? "" : ", ") + item;
        }
        Add(name, "[" + list + "]", tooltip);
    }
    void BeginGroup(std::string_view name) override { m_Group = std::string(name) + "."; }
    void EndGroup() override { m_Group.clear(); }
    void RenderingLayerIndex(std::string_view name, int& value, std::string_view tooltip) override
    {
        const std::string& layer = m_RenderingLayers.Name(value);
        Add(name, layer.empty() ? std::to_string(value) : layer, tooltip);
    }
    void EnumField(std::string_view name, int& value, std::span<const EnumEntry> entries,
                   std::string_view tooltip) override
    {
        std::string text = std::to_string(value);
        for (const EnumEntry& entry : entries)
        {
            text = entry.value == value ? std::string(entry.name) : text;
        }
        Add(name, text, tooltip);
    }

    std::vector<InspectedValue> values;

private:
    void Add(std::string_view name, std::string value, std::string_view tooltip,
             std::optional<ValueRange> range = std::nullopt)
    {
        InspectedValue& result = values.emplace_back();
        result.header = m_Header;
        result.name = m_Group + std::string(name);
        result.value = std::move(value);
        result.range = range;
        result.tooltip = tooltip;
    }

    const LayerNames& m_Layers;
    const LayerNames& m_RenderingLayers;
    std::string m_Header;
    std::string m_Group; ///< with a dot, or empty
};

} // namespace

std::vector<InspectedValue> CollectSettings(ScriptableRendererFeature& feature,
                                            ScriptableRendererFeature& defaultFeature,
                                            const LayerNames& layers,
                                            const LayerNames& renderingLayers)
{
    SettingsCollector collector(layers, renderingLayers);
    feature.Describe(collector);
    SettingsCollector defaults(layers, renderingLayers);
    defaultFeature.Describe(defaults);
    for (std::size_t i = 0; i < collector.values.size(); ++i)
    {
        InspectedValue& value = collector.values[i];
        value.defaultValue = defaults.values.at(i).value;
        value.isOverridden = value.value != value.defaultValue;
    }
    return std::move(collector.values);
}

} // namespace limn
