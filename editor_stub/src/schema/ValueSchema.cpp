
#include "console/Texts.h"
#include "schema/Schemas.h"
#include "settings/Keys.h"

#include <cmath>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

namespace
{

Json NumberOfType(const char* type, ValueRange range)
{
    Json schema{{"type", type}};
    if (std::isfinite(range.min))
    {
        schema["minimum"] = Json::parse(NumberText(range.min));
    }
    if (std::isfinite(range.max))
    {
        schema["maximum"] = Json::parse(NumberText(range.max));
    }
    return schema;
}

/// So many numbers in a list.
Json NumbersSchema(int least, int most, ValueRange range)
{
    return {
        {"type", "array"}, {"items", NumberSchema(range)}, {"minItems", least}, {"maxItems", most}};
}

/// Numbers by one-letter names, of which the first `required` must be there.
Json FieldsSchema(std::string_view names, std::size_t required, ValueRange range)
{
    Json schema = MapSchema(Json::object());
    schema["required"] = Json::array();
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        const std::string name(names.substr(i, 1));
        schema["properties"][name] = NumberSchema(range);
        if (i < required)
        {
            schema["required"].push_back(name);
        }
    }
    return schema;
}

/// A number, or one of the words for a vertical tangent.
Json TangentSchema()
{
    return {{"anyOf", {NumberSchema(), {{"enum", {"Infinity", "-Infinity", ".inf", "-.inf"}}}}}};
}

Json KeysSchema()
{
    Json key = MapSchema({{"time", NumberSchema()},
                          {"value", NumberSchema()},
                          {"inTangent", TangentSchema()},
                          {"outTangent", TangentSchema()},
                          {"inSlope", TangentSchema()},
                          {"outSlope", TangentSchema()},
                          {"inWeight", NumberSchema()},
                          {"outWeight", NumberSchema()},
                          {"weightedMode", IntegerSchema({0.0, 3.0})},
                          {"tangentMode", IntegerSchema()},
                          {"serializedVersion", IntegerSchema()}});
    key["required"] = {"time", "value"};
    return ListSchema(std::move(key));
}

/// One of the names, or a member's number.
Json MemberSchema(Json names)
{
    return AnyOf({{{"enum", std::move(names)}}, {{"type", "integer"}}});
}

Json WrapModeSchema()
{
    return MemberSchema({"Loop", "PingPong", "ClampForever", "Once", "Clamp", "Default"});
}

} // namespace

Json BoolSchema()
{
    return AnyOf({{{"type", "boolean"}}, {{"enum", {0, 1}}}});
}

Json NumberSchema(ValueRange range)
{
    return NumberOfType("number", range);
}

Json IntegerSchema(ValueRange range)
{
    return NumberOfType("integer", range);
}

Json TextSchema()
{
    // A name such as 12 needs no quotes in a file.
    return {{"type", {"string", "number", "boolean"}}};
}

Json ColorSchema()
{
    const Json hex{{"type", "string"}, {"pattern", "^#([0-9a-fA-F]{6}|[0-9a-fA-F]{8})$"}};
    return AnyOf(
        {FieldsSchema("rgba", 3, k_ColorChannels), NumbersSchema(3, 4, k_ColorChannels), hex});
}

Json VectorSchema(int count, ValueRange range)
{
    const auto size = static_cast<std::size_t>(count);
    return AnyOf({NumbersSchema(count, count, range),
                  FieldsSchema(std::string_view("xyzw").substr(0, size), size, range)});
}

Json LayerIndexSchema()
{
    return AnyOf({IntegerSchema(k_LayerIndices), {{"type", "string"}}});
}

Json LayerMaskSchema()
{
    const Json bits = IntegerSchema(k_LayerBits);
    Json unity = MapSchema({{"serializedVersion", IntegerSchema()}, {"m_Bits", bits}});
    unity["required"] = {"m_Bits"};
    return AnyOf({{{"enum", {"Everything", "Nothing"}}},
                  {{"type", "string"}},
                  ListSchema(LayerIndexSchema()),
                  bits,
                  std::move(unity)});
}

Json ReferenceSchema()
{
    const Json guid{{"type", "string"}, {"pattern", "^[0-9a-fA-F]{32}$"}};
    Json unitys =
        MapSchema({{"fileID", IntegerSchema()}, {"guid", guid}, {"type", IntegerSchema()}});
    unitys["required"] = {"fileID"};
    return AnyOf({{{"type", {"string", "null"}}}, std::move(unitys)});
}

Json EnumSchema(std::span<const std::string> names)
{
    return MemberSchema(JsonList(names, std::identity()));
}

Json EnumSchema(std::span<const EnumEntry> entries)
{
    const Json names = JsonList(entries, &EnumEntry::name);
    Json schema = MemberSchema(names);
    if (std::ranges::find(entries, "Everything", &EnumEntry::name) != entries.end())
    {
        schema["anyOf"].push_back(ListSchema({{"enum", names}}));
    }
    return schema;
}

Json RenderPassEventSchema()
{
    const std::string names = Joined(RenderPassEventEntries(), "|", &EnumEntry::name);
    Json schema = EnumSchema(RenderPassEventEntries());
    schema["anyOf"].push_back({{"type", "string"}, {"pattern", "^(" + names + ") *[+-] *[0-9]+$"}});
    return schema;
}

Json MapSchema(Json properties)
{
    return {
        {"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

Json ListSchema(Json items)
{
    return {{"type", "array"}, {"items", std::move(items)}};
}

Json WithDescription(Json schema, std::string_view text)
{
    schema["description"] = text;
    return schema;
}

Json AnyOf(std::initializer_list<Json> schemas)
{
    return {{"anyOf", Json::array_t(schemas)}};
}

void AddProperty(Json& map, std::string_view name, const Json& value)
{
    const std::string plain = PlainSpelling(name);
    map["properties"][std::string(name)] = value;
    if (plain != name)
    {
        map["properties"][plain] = value;
        map["allOf"].push_back(
            {{"not", {{"type", "object"}, {"required", {std::string(name), plain}}}}});
    }
}

Json RootSchema(std::string_view title, const Json& map)
{
    Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
    schema.update(map);
    return schema;
}

Json ToJson(const YamlNode& node)
{
    Json json;
    for (const YamlNode& item : node.items())
    {
        json.push_back(ToJson(item));
    }
    for (const YamlEntry& entry : node.entries())
    {
        json[entry.key] = ToJson(entry.value);
    }
    if (!node.isScalar())
    {
        return json.is_null() && node.isSequence() ? Json::array() : json;
    }
    const Json number = node.isQuoted() ? Json() : Json::parse(node.scalar(), nullptr, false);
    return number.is_number() || number.is_boolean() ? number : Json(node.scalar());
}

Json AnimationCurveSchema()
{
    Json own = MapSchema({{"keys", KeysSchema()},
                          {"preWrapMode", WrapModeSchema()},
                          {"postWrapMode", WrapModeSchema()}});
    own["required"] = {"keys"};
    // Unity's form holds more, which depends on its version.
    Json unitys{{"type", "object"},
                {"properties",
                 {{"m_Curve", KeysSchema()},
                  {"m_PreInfinity", IntegerSchema({0.0, 2.0})},
                  {"m_PostInfinity", IntegerSchema({0.0, 2.0})}}}};
    unitys["required"] = {"m_Curve"};
    return {{"anyOf", {KeysSchema(), std::move(own), std::move(unitys)}}};
}

Json TextureCurveSchema()
{
    Json own = MapSchema({{"keys", AnimationCurveSchema()}});
    Json unitys = MapSchema(
        {{"m_Curve", AnimationCurveSchema()}, {"<length>k__BackingField", IntegerSchema()}});
    own["required"] = {"keys"};
    unitys["required"] = {"m_Curve"};
    for (Json* form : {&own, &unitys})
    {
        AddProperty(*form, "m_ZeroValue", NumberSchema());
        AddProperty(*form, "m_Loop", BoolSchema());
        AddProperty(*form, "m_Range", NumberSchema({0.0}));
    }
    return {{"anyOf", {std::move(own), std::move(unitys)}}};
}

} // namespace limn
