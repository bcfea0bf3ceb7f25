#include "schema/Schemas.h"

#include "console/Texts.h"
#include "settings/Keys.h"
#include "settings/ShadowKeys.h"

#include <limn/core/BuiltinShaders.h>
#include <limn/core/PrimitiveMesh.h>

namespace limn
{

namespace
{

Json ScaleSchema()
{
    Json schema = VectorSchema(3);
    schema["anyOf"].push_back(NumberSchema());
    return schema;
}

Json ColliderTypeSchema()
{
    return {{"enum", JsonList(scene_keys::k_ColliderShapes, &ColliderShape::type)}};
}

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
            schema["properties"][name] = WithDescription(Value(key), key.description);
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
        switch (key.type.value)
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
            return {{"type", "array"},
                    {"items", IntegerSchema(k_PictureSizes)},
                    {"minItems", 2},
                    {"maxItems", 2}};
        case SceneValue::Layer:
            return LayerIndexSchema();
        case SceneValue::Layers:
            return LayerMaskSchema();
        case SceneValue::LayerNames:
            return {{"type", "object"},
                    {"propertyNames", {{"pattern", "^([0-9]|[12][0-9]|3[01])$"}}},
                    {"additionalProperties", TextSchema()}};
        case SceneValue::Enum:
            return EnumSchema(key.type.entries);
        case SceneValue::Mesh:
            return AnyOf({{{"enum", PrimitiveTypeNames()}}, {{"type", "string"}}});
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
        case SceneValue::Lights:
            return ListSchema(Map(scene_keys::k_AdditionalLight));
        case SceneValue::Shadows:
            return Shadows();
        case SceneValue::RenderSettings:
            return Map(scene_keys::k_RenderSettings);
        case SceneValue::Renderer:
            return Renderer();
        case SceneValue::Features:
            return ListSchema(FeatureSchema(m_Features));
        case SceneValue::Volumes:
            return ListSchema(Map(scene_keys::k_Volume));
        case SceneValue::Colliders:
            return ListSchema(Collider());
        case SceneValue::Materials:
            return {{"type", "object"}, {"additionalProperties", NamedMaterialSchema()}};
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

    /// A material as a scene's map of materials has it, or the name of a file with one.
    static Json NamedMaterialSchema()
    {
        const Json file{{"type", "string"},
                        {"pattern", "\\.material\\.yaml$"},
                        {"description", "A .material.yaml file"}};
        return {{"if", {{"type", "string"}}}, {"then", file}, {"else", MaterialSchema()}};
    }

    static Json Shadows()
    {
        ShadowSettings settings;
        Json map = MapSchema(Json::object());
        const auto add = [&map](std::string_view name, const auto& value, ValueRange range,
                                std::string_view text)
        {
            using Value = std::decay_t<decltype(value)>;
            Json schema = std::is_same_v<Value, bool>        ? BoolSchema()
                          : std::is_same_v<Value, int>       ? IntegerSchema(range)
                          : std::is_same_v<Value, float>     ? NumberSchema(range)
                          : std::is_same_v<Value, glm::vec2> ? VectorSchema(2, range)
                          : std::is_same_v<Value, glm::vec3> ? VectorSchema(3, range)
                                                             : EnumSchema(k_SoftShadowQualities);
            AddProperty(map, name, WithDescription(schema, text));
        };
        VisitShadowSettings(settings, add);
        return map;
    }

    Json Renderer() const
    {
        Json schema = Map(scene_keys::k_Renderer);
        schema["not"] = {{"type", "object"},
                         {"required", JsonList(scene_keys::k_Renderer, &SceneKey::name)}};
        schema["type"] = {"object", "string", "null"};
        return schema;
    }

    Json Collider() const
    {
        const Json type = WithDescription(ColliderTypeSchema(), scene_keys::k_Type.description);
        Json schema{{"type", "object"}, {"properties", {{"type", type}}}};
        for (const ColliderShape& shape : scene_keys::k_ColliderShapes)
        {
            Json isThis{{"properties", {{"type", {{"const", shape.type}}}}}};
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

/// A texture of several files, under one key.
Json SlicesSchema(const char* key, int least, const char* description)
{
    Json list = ListSchema({{"type", "string"}, {"pattern", "\\.png$"}});
    list["minItems"] = least;
    list["description"] = description;
    Json map = MapSchema({{key, std::move(list)}});
    map["required"] = Json::array({key});
    return map;
}

} // namespace

Json SceneSchema(const FeatureRegistry& features)
{
    const SceneSchemaWriter writer(features);
    Json schema = writer.Map(scene_keys::k_Scene);
    schema["$defs"] = {{"object", writer.Map(scene_keys::k_Object)}};
    return RootSchema("limn scene", schema);
}

Json MaterialSchema()
{
    // The shader, a file of its own, decides which properties there are, but their types are known
    // here.
    const Json texture{{"type", "string"},
                       {"pattern", "^(" + Joined(DefaultTextureNames(), "|") + ")$|\\.png$"}};
    Json property{{"anyOf",
                   {NumberSchema(), ColorSchema(), VectorSchema(4), texture,
                    SlicesSchema("faces", 6, "The faces of a cube in the order +X -X +Y -Y +Z -Z"),
                    SlicesSchema("slices", 1, "The slices of a 3D texture or an array")}},
                  {"description", "A property of the shader: a number, a colour, four numbers or "
                                  "a texture"}};
    return {{"type", {"object", "null"}},
            {"properties",
             {{"shader", WithDescription(TextSchema(), "A shader's name or a .shader file")},
              {"renderQueue",
               WithDescription(IntegerSchema(k_RenderQueues),
                               "The place in the order of drawing; -1 takes the shader's own")}}},
            {"additionalProperties", std::move(property)}};
}

} // namespace limn
