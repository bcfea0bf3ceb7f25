#include "SceneSchema.h"

#include "FeatureSchema.h"

#include <limn/core/PrimitiveMesh.h>

namespace limn
{

namespace
{

constexpr double k_MaxDistance = 1e9;

/// A key whose value begins with it.
Json Described(Json schema, const char* description)
{
    schema["description"] = description;
    return schema;
}

Json LayerNamesSchema()
{
    return {{"type", "object"},
            {"propertyNames", {{"pattern", "^([0-9]|[12][0-9]|3[01])$"}}},
            {"additionalProperties", TextSchema()}};
}

Json CameraSchema()
{
    Json schema = MapSchema({
        {"position", VectorSchema(3)},
        {"rotation", Described(VectorSchema(3), "Euler angles in degrees, applied z, x, y")},
        {"lookAt", Described(VectorSchema(3), "A point to look at, in place of a rotation")},
        {"orthographic", BoolSchema()},
        {"orthographicSize", NumberSchema({1e-4, k_MaxDistance})},
        {"fieldOfView", Described(NumberSchema({0.01, 179.0}), "Vertical, in degrees")},
        {"nearClipPlane", NumberSchema({-k_MaxDistance, k_MaxDistance})},
        {"farClipPlane", NumberSchema({-k_MaxDistance, k_MaxDistance})},
        {"clearFlags",
         EnumSchema(std::vector<std::string>{"Skybox", "SolidColor", "Depth", "Nothing"})},
        {"backgroundColor", ColorSchema()},
        {"allowHDR", BoolSchema()},
        {"cullingMask", LayerMaskSchema()},
        {"volumeLayerMask", LayerMaskSchema()},
        {"volumeTrigger", VectorSchema(3)},
    });
    schema["type"] = {"object", "null"};
    return schema;
}

Json LightSchema()
{
    return MapSchema({{"rotation", VectorSchema(3)},
                      {"color", ColorSchema()},
                      {"intensity", NumberSchema({0.0, 1e6})}});
}

void AddTransform(Json& schema)
{
    Json& properties = schema["properties"];
    properties["position"] = VectorSchema(3);
    properties["rotation"] = Described(VectorSchema(3), "Euler angles in degrees");
    properties["scale"] = VectorSchema(3);
    properties["scale"]["anyOf"].push_back(NumberSchema());
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

Json ColliderSchema()
{
    return MapSchema({{"type", {{"enum", {"box", "sphere", "capsule", "mesh"}}}},
                      {"enabled", BoolSchema()},
                      {"center", VectorSchema(3)},
                      {"size", VectorSchema(3)},
                      {"radius", NumberSchema({0.0, k_MaxDistance})},
                      {"height", NumberSchema({0.0, k_MaxDistance})},
                      {"direction", {{"enum", {"x", "y", "z"}}}},
                      {"mesh", MeshSchema()}});
}

Json VolumeSchema()
{
    Json schema = MapSchema({
        {"name", TextSchema()},
        {"profile", Described(TextSchema(), "A *.profile.yaml or a Unity .asset file")},
        {"enabled", BoolSchema()},
        {"isGlobal", BoolSchema()},
        {"priority", Described(NumberSchema(), "The higher one wins")},
        {"weight", NumberSchema({0.0, 1.0})},
        {"blendDistance", Described(NumberSchema({0.0, k_MaxDistance}), "Metres")},
        {"layer", LayerIndexSchema()},
        {"colliders", ListSchema(ColliderSchema())},
    });
    AddTransform(schema);
    schema["required"] = {"profile"};
    return schema;
}

Json MaterialSchema()
{
    // The rest are properties of the shader, which a file of its own declares.
    return {{"type", {"object", "null"}},
            {"properties",
             {{"shader", Described(TextSchema(), "A shader's name or a .shader file")},
              {"renderQueue", IntegerSchema({-1.0, 5000.0})}}}};
}

Json ObjectSchema()
{
    Json schema = MapSchema({
        {"name", TextSchema()},
        {"active", BoolSchema()},
        {"layer", LayerIndexSchema()},
        {"renderingLayerMask", LayerMaskSchema()},
        {"mesh", MeshSchema()},
        {"material", TextSchema()},
        {"materials", ListSchema(TextSchema())},
        {"bakeOutlineNormals",
         Described(BoolSchema(), "Gives the mesh what TranslucentOutlineHull goes by")},
        {"children", ListSchema({{"$ref", "#/$defs/object"}})},
    });
    AddTransform(schema);
    schema["required"] = {"name"};
    return schema;
}

Json SizeSchema()
{
    return {{"type", "array"},
            {"items", IntegerSchema({1.0, 16384.0})},
            {"minItems", 2},
            {"maxItems", 2},
            {"description", "Width and height in pixels"}};
}

} // namespace

Json SceneSchema()
{
    Json renderer =
        MapSchema({{"rendererData", TextSchema()}, {"features", ListSchema(FeatureSchema())}});
    renderer["not"] = {{"required", {"rendererData", "features"}}};
    Json schema = MapSchema({
        {"size", SizeSchema()},
        {"layers", LayerNamesSchema()},
        {"renderingLayers", LayerNamesSchema()},
        {"camera", CameraSchema()},
        {"light", LightSchema()},
        {"ambientLight", ColorSchema()},
        {"renderer", std::move(renderer)},
        {"volumes", ListSchema(VolumeSchema())},
        {"materials", {{"type", "object"}, {"additionalProperties", MaterialSchema()}}},
        {"objects", ListSchema({{"$ref", "#/$defs/object"}})},
    });
    schema["required"] = {"camera"};
    schema["$defs"] = {{"object", ObjectSchema()}};
    return RootSchema("limn scene", schema);
}

} // namespace limn
