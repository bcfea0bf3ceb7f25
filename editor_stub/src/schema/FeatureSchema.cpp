#include "plugins/LoadPlugin.h"
#include "schema/Schemas.h"
#include "settings/Keys.h"

#include <algorithm>
#include <limn/core/ComputeShader.h>
#include <limn/core/Material.h>

namespace limn
{

namespace
{

Json NameOf(std::span<const EnumEntry> entries, int value)
{
    const auto found = std::ranges::find(entries, value, &EnumEntry::value);
    return found == entries.end() ? Json(value) : Json(found->name);
}

/// A schema, and the default that stands in it.
struct SettingSchema
{
    Json schema;
    Json defaultValue;
};

/// The schema of a setting, by its type.
struct SchemaOfSetting
{
    ValueRange range;

    SettingSchema operator()(const bool* value) const { return {BoolSchema(), *value}; }
    SettingSchema operator()(const int* value) const { return {IntegerSchema(range), *value}; }
    SettingSchema operator()(const std::uint32_t* value) const
    {
        return {IntegerSchema(
                    {std::max(range.min, k_LayerBits.min), std::min(range.max, k_LayerBits.max)}),
                *value};
    }
    SettingSchema operator()(const float* value) const
    {
        return {NumberSchema(range), Json::parse(NumberText(static_cast<double>(*value)))};
    }
    SettingSchema operator()(const Color* value) const
    {
        return {ColorSchema(),
                {{"r", value->r}, {"g", value->g}, {"b", value->b}, {"a", value->a}}};
    }
    template <int Size>
    SettingSchema operator()(const glm::vec<Size, float>* value) const
    {
        return {VectorSchema(Size), std::vector<float>(&value->x, &value->x + Size)};
    }
    template <typename Tag>
    SettingSchema operator()(const detail::BitMask32<Tag>* value) const
    {
        return {LayerMaskSchema(), value->bits};
    }
    SettingSchema operator()(const RenderPassEvent* value) const
    {
        return {RenderPassEventSchema(),
                NameOf(RenderPassEventEntries(), static_cast<int>(*value))};
    }
    SettingSchema operator()(const std::string* value) const { return {TextSchema(), *value}; }
    SettingSchema operator()(const std::vector<std::string>* value) const
    {
        return {{{"type", "array"}, {"items", TextSchema()}}, *value};
    }
    template <typename Asset>
    SettingSchema operator()(const std::shared_ptr<const Asset>* value) const
    {
        return {TextSchema(), *value ? Json((*value)->name()) : Json()};
    }
    SettingSchema operator()(EnumValue value) const
    {
        return {EnumSchema(value.entries), NameOf(value.entries, value.value)};
    }
    SettingSchema operator()(RenderingLayerValue value) const
    {
        return {LayerIndexSchema(), value.value};
    }
};

/// Makes a schema of the settings that a feature names; their values are the defaults.
class SchemaInspector final : public Inspector
{
public:
    explicit SchemaInspector(Json& map) : m_Root(map) {}

    void Header(std::string_view text) override { m_Header = text; }
    void BeginGroup(std::string_view name) override
    {
        m_Groups.push_back({std::string(name), MapSchema(Json::object())});
    }
    void EndGroup() override
    {
        const Group group = std::move(m_Groups.back());
        m_Groups.pop_back();
        AddProperty(Map(), group.name,
                    WithDescription(group.schema, "Settings that belong together"));
    }
    void Field(const FieldInfo& field, FieldValue value) override
    {
        auto [schema, defaultValue] =
            std::visit(SchemaOfSetting{field.range.value_or(ValueRange())}, value);
        if (!defaultValue.is_null())
        {
            schema["default"] = defaultValue;
        }
        const std::string header = m_Header.empty() ? "" : m_Header + ": ";
        schema["description"] = header + std::string(field.tooltip);
        AddProperty(Map(), field.name, schema);
    }

private:
    struct Group
    {
        std::string name;
        Json schema;
    };

    Json& Map() { return m_Groups.empty() ? m_Root : m_Groups.back().schema; }

    Json& m_Root;
    std::vector<Group> m_Groups; ///< that the fields are in now, the outermost first
    std::string m_Header;
};

} // namespace

Json FeatureSchema(const FeatureRegistry& features)
{
    Json schema{{"type", "object"}, {"required", {"type"}}};
    for (const std::string_view type : features.names())
    {
        const std::string name(type);
        Json map = MapSchema({{"type", {{"const", name}}},
                              {"name", WithDescription(TextSchema(), "A name, by which messages "
                                                                     "and `--set` call it")},
                              {"active", WithDescription(BoolSchema(), "Lets the feature add its "
                                                                       "passes; on unless it is "
                                                                       "set")}});
        map["properties"]["type"]["description"] = "The feature's class";
        SchemaInspector inspector(map);
        DescribeFeature(*features.Create(type), inspector);
        Json isThisType{{"properties", {{"type", {{"const", name}}}}}, {"required", {"type"}}};
        schema["allOf"].push_back({{"if", std::move(isThisType)}, {"then", std::move(map)}});
    }
    schema["properties"]["type"] = {{"enum", features.names()},
                                    {"description", "The feature's class"}};
    return schema;
}

} // namespace limn
