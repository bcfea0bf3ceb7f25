#include "schema/FeatureSchema.h"

#include <limn/core/Material.h>

namespace limn
{

namespace
{

/// Makes a schema of the settings that a feature names; their values are the defaults.
class SchemaInspector final : public Inspector
{
public:
    explicit SchemaInspector(Json& map) : m_Map(&map), m_Root(map) {}

    void Header(std::string_view text) override { m_Header = text; }
    void Field(std::string_view name, bool& value, std::string_view tooltip) override
    {
        Add(name, BoolSchema(), value, tooltip);
    }
    void Field(std::string_view name, int& value, FieldRange range,
               std::string_view tooltip) override
    {
        Add(name, IntegerSchema({range.minimum, range.maximum}), value, tooltip);
    }
    void Field(std::string_view name, float& value, FieldRange range,
               std::string_view tooltip) override
    {
        const std::string text = NumberText(static_cast<double>(value));
        Add(name, NumberSchema({range.minimum, range.maximum}), Json::parse(text), tooltip);
    }
    void Field(std::string_view name, Color& value, std::string_view tooltip) override
    {
        Add(name, ColorSchema(), {{"r", value.r}, {"g", value.g}, {"b", value.b}, {"a", value.a}},
            tooltip);
    }
    void Field(std::string_view name, LayerMask& value, std::string_view tooltip) override
    {
        Add(name, LayerMaskSchema(), value.bits, tooltip);
    }
    void Field(std::string_view name, RenderPassEvent& value, std::string_view tooltip) override
    {
        Add(name, RenderPassEventSchema(),
            NameOf(RenderPassEventEntries(), static_cast<int>(value)), tooltip);
    }
    void Field(std::string_view name, std::shared_ptr<const Shader>& value,
               std::string_view tooltip) override
    {
        Add(name, TextSchema(), value ? Json(value->name()) : Json(), tooltip);
    }
    void Field(std::string_view name, std::shared_ptr<const Material>& value,
               std::string_view tooltip) override
    {
        Add(name, TextSchema(), value ? Json(value->name()) : Json(), tooltip);
    }
    void Field(std::string_view name, glm::vec4& value, std::string_view tooltip) override
    {
        Add(name, VectorSchema(4), {value.x, value.y, value.z, value.w}, tooltip);
    }
    void Field(std::string_view name, std::string& value, std::string_view tooltip) override
    {
        Add(name, TextSchema(), value, tooltip);
    }
    void Field(std::string_view name, std::vector<std::string>& value,
               std::string_view tooltip) override
    {
        Add(name, {{"type", "array"}, {"items", TextSchema()}}, value, tooltip);
    }
    void BeginGroup(std::string_view name) override
    {
        m_GroupName = name;
        m_GroupSchema = MapSchema(Json::object());
        m_Map = &m_GroupSchema;
    }
    void EndGroup() override
    {
        m_Map = &m_Root;
        AddProperty(m_Root, m_GroupName, m_GroupSchema);
    }
    void RenderingLayerIndex(std::string_view name, int& value, std::string_view tooltip) override
    {
        Add(name, LayerIndexSchema(), value, tooltip);
    }
    void EnumField(std::string_view name, int& value, std::span<const EnumEntry> entries,
                   std::string_view tooltip) override
    {
        std::vector<std::string> names;
        for (const EnumEntry& entry : entries)
        {
            names.emplace_back(entry.name);
        }
        Add(name, EnumSchema(names), NameOf(entries, value), tooltip);
    }

private:
    static Json NameOf(std::span<const EnumEntry> entries, int value)
    {
        for (const EnumEntry& entry : entries)
        {
            if (entry.value == value)
            {
                return std::string(entry.name);
            }
        }
        return value;
    }

    void Add(std::string_view name, Json schema, const Json& value, std::string_view tooltip)
    {
        if (!value.is_null())
        {
            schema["default"] = value;
        }
        const std::string header = m_Header.empty() ? "" : m_Header + ": ";
        schema["description"] = header + std::string(tooltip);
        AddProperty(*m_Map, name, schema);
    }

    Json* m_Map; ///< of the group, or the root
    Json& m_Root;
    Json m_GroupSchema;
    std::string m_GroupName;
    std::string m_Header;
};

} // namespace

Json FeatureSchema(const FeatureRegistry& features)
{
    Json types = Json::array();
    Json schema{{"type", "object"}, {"required", {"type"}}};
    for (const std::string_view type : features.names())
    {
        const std::string name(type);
        types.push_back(name);
        Json map = MapSchema(
            {{"type", {{"const", name}}}, {"name", TextSchema()}, {"active", BoolSchema()}});
        SchemaInspector inspector(map);
        features.Create(type)->Describe(inspector);
        Json isThisType{{"properties", {{"type", {{"const", name}}}}}, {"required", {"type"}}};
        schema["allOf"].push_back({{"if", std::move(isThisType)}, {"then", std::move(map)}});
    }
    schema["properties"]["type"] = {{"enum", std::move(types)}};
    return schema;
}

} // namespace limn
