#include "schema/Schemas.h"

#include "settings/ShadowKeys.h"

#include <limn/core/PrimitiveMesh.h>

namespace limn
{

namespace
{

Json LayerNamesSchema()
{
    return {{"type", "object"},
            {"propertyNames", {{"pattern", "^([0-9]|[12][0-9]|3[01])$"}}},
            {"additionalProperties", TextSchema()}};
}

Json ScaleSchema()
{
    Json schema = VectorSchema(3);
    schema["anyOf"].push_back(NumberSchema());
    return schema;
}

Json SizeSchema()
{
    return {{"type", "array"},
            {"items", IntegerSchema(k_PictureSizes)},
            {"minItems", 2},
            {"maxItems", 2}};
}

Json MeshSchema()
{
    Json names = Json::array();
    for (const std::string_view name : PrimitiveTypeNames())
    {
        names.push_back(std::string(name));
    }
    Json schema{{"anyOf", Json::array()}};
    schema["anyOf"].push_back({{"enum", std::move(names)}});
    schema["anyOf"].push_back({{"type", "string"}});
    return schema;
}

Json ColliderTypeSchema()
{
    Json types = Json::array();
    for (const ColliderShape& shape : scene_keys::k_ColliderShapes)
    {
        types.push_back(std::string(shape.type));
    }
    return {{"enum", std::move(types)}};
}

/// Adds one setting after the other.
class ShadowSchema
{
public:
    void operator()(std::string_view name, const bool&, ValueRange, std::string_view text)
    {
        Add(name, BoolSchema(), text);
    }
    void operator()(std::string_view name, const int&, ValueRange range, std::string_view text)
    {
        Add(name, IntegerSchema(range), text);
    }
    void operator()(std::string_view name, const float&, ValueRange range, std::string_view text)
    {
        Add(name, NumberSchema(range), text);
    }
    void operator()(std::string_view name, const glm::vec2&, ValueRange range,
                    std::string_view text)
    {
        Add(name, VectorSchema(2, range), text);
    }
    void operator()(std::string_view name, const glm::vec3&, ValueRange range,
                    std::string_view text)
    {
        Add(name, VectorSchema(3, range), text);
    }
    void operator()(std::string_view name, const SoftShadowQuality&, ValueRange,
                    std::string_view text)
    {
        Add(name, EnumSchema(k_SoftShadowQualities), text);
    }

    Json map = MapSchema(Json::object());

private:
    void Add(std::string_view name, Json value, std::string_view text)
    {
        if (!text.empty())
        {
            value["description"] = std::string(text);
        }
        AddProperty(map, name, value);
    }
};

/// Makes the schema of a map from its keys.
class SceneSchemaWriter
{
public:
    explicit SceneSchemaWriter(const FeatureRegistry& features) : m_Features(features) {}

    Json Map(SceneKeys keys) const
    {
        Json schema = MapSchema(Json::object());
        for (const SceneKey& key : keys)
        {
            const std::string name(key.name);
            Json value = Value(key);
            if (!key.description.empty())
            {
                value["description"] = std::string(key.description);
            }
            schema["properties"][name] = std::move(value);
            if (key.isRequired)
            {
                schema["required"].push_back(name);
            }
        }
        return schema;
    }

private:
    Json Value(const SceneKey& key) const
    {
        switch (key.value)
        {
        case SceneValue::Bool:
            return BoolSchema();
        case SceneValue::Number:
            return NumberSchema(key.range);
        case SceneValue::Integer:
            return IntegerSchema(key.range);
        case SceneValue::Text:
            return TextSchema();
        case SceneValue::Texts:
            return ListSchema(TextSchema());
        case SceneValue::Color:
            return ColorSchema();
        case SceneValue::Vector:
            return VectorSchema(3, key.range);
        case SceneValue::Scale:
            return ScaleSchema();
        case SceneValue::Size:
            return SizeSchema();
        case SceneValue::Layer:
            return LayerIndexSchema();
        case SceneValue::Layers:
            return LayerMaskSchema();
        case SceneValue::LayerNames:
            return LayerNamesSchema();
        case SceneValue::ClearFlags:
            return EnumSchema(k_ClearFlags);
        case SceneValue::TransparencySortMode:
            return EnumSchema(k_TransparencySortModes);
        case SceneValue::MsaaQuality:
            return EnumSchema(k_MsaaQualities);
        case SceneValue::HdrPrecision:
            return EnumSchema(k_HdrBits);
        case SceneValue::Mesh:
            return MeshSchema();
        case SceneValue::ColliderType:
            return ColliderTypeSchema();
        case SceneValue::Axis:
            return {{"enum", {"x", "y", "z"}}};
        case SceneValue::Camera:
            return Camera();
        case SceneValue::CameraStack:
            return ListSchema(Map(scene_keys::k_OverlayCamera));
        case SceneValue::Light:
            return Map(scene_keys::k_Light);
        case SceneValue::LightType:
            return EnumSchema(k_LightTypes);
        case SceneValue::Lights:
            return ListSchema(Map(scene_keys::k_AdditionalLight));
        case SceneValue::LightShadows:
            return EnumSchema(k_LightShadows);
        case SceneValue::LightShadowQuality:
            return EnumSchema(k_LightShadowQualities);
        case SceneValue::ShadowResolutionTier:
            return EnumSchema(k_ShadowResolutionTiers);
        case SceneValue::ShadowCastingMode:
            return EnumSchema(k_ShadowCastingModes);
        case SceneValue::Shadows:
            return Shadows();
        case SceneValue::Renderer:
            return Renderer();
        case SceneValue::Features:
            return ListSchema(FeatureSchema(m_Features));
        case SceneValue::Volumes:
            return ListSchema(Map(scene_keys::k_Volume));
        case SceneValue::Colliders:
            return ListSchema(Collider());
        case SceneValue::Materials:
            return {{"type", "object"}, {"additionalProperties", MaterialSchema()}};
        case SceneValue::Objects:
            return ListSchema({{"$ref", "#/$defs/object"}});
        }
        return {};
    }

    Json Camera() const
    {
        Json schema = Map(scene_keys::k_Camera);
        schema["type"] = {"object", "null"};
        return schema;
    }

    static Json Shadows()
    {
        ShadowSettings settings;
        ShadowSchema schema;
        VisitShadowSettings(settings, schema);
        return schema.map;
    }

    Json Renderer() const
    {
        Json schema = Map(scene_keys::k_Renderer);
        schema["not"]["type"] = "object";
        for (const SceneKey& key : scene_keys::k_Renderer)
        {
            schema["not"]["required"].push_back(std::string(key.name));
        }
        schema["type"] = {"object", "string", "null"};
        return schema;
    }

    Json Collider() const
    {
        Json schema{{"type", "object"}, {"properties", {{"type", ColliderTypeSchema()}}}};
        for (const ColliderShape& shape : scene_keys::k_ColliderShapes)
        {
            Json isThis{{"properties", {{"type", {{"const", std::string(shape.type)}}}}}};
            if (&shape != scene_keys::k_ColliderShapes.begin())
            {
                isThis["required"] = {"type"}; // a condition on a key that is not there holds
            }
            schema["allOf"].push_back({{"if", std::move(isThis)}, {"then", Map(shape.keys)}});
        }
        return schema;
    }

    const FeatureRegistry& m_Features;
};

} // namespace

Json SceneSchema(const FeatureRegistry& features)
{
    const SceneSchemaWriter writer(features);
    Json schema = writer.Map(scene_keys::k_Scene);
    schema["$defs"] = {{"object", writer.Map(scene_keys::k_Object)}};
    return RootSchema("limn scene", schema);
}

} // namespace limn
