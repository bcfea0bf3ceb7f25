#include "schema/Schemas.h"

#include "scene/Limits.h"

#include <limn/core/PrimitiveMesh.h>

namespace limn
{

namespace
{

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
        {"position", VectorSchema(3, k_Places)},
        {"rotation", Described(VectorSchema(3), "Euler angles in degrees, applied z, x, y")},
        {"lookAt",
         Described(VectorSchema(3, k_Places), "A point to look at, in place of a rotation")},
        {"orthographic", BoolSchema()},
        {"orthographicSize", NumberSchema(k_OrthographicSizes)},
        {"fieldOfView", Described(NumberSchema(k_FieldsOfView), "Vertical, in degrees")},
        {"nearClipPlane", NumberSchema(k_ClipPlanes)},
        {"farClipPlane", NumberSchema(k_ClipPlanes)},
        {"clearFlags", EnumSchema(k_ClearFlags)},
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
                      {"intensity", NumberSchema(k_Intensities)}});
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

/// What one type of collider holds besides `type` and `enabled`.
Json ShapeSchema(std::string_view name)
{
    const Json length = NumberSchema(k_Lengths);
    Json shape = MapSchema({{"type", Json::object()}, {"enabled", Json::object()}});
    Json& properties = shape["properties"];
    if (name == "mesh")
    {
        properties["mesh"] = MeshSchema();
        shape["required"] = {"mesh"};
        return shape;
    }
    properties["center"] = VectorSchema(3);
    if (name == "box")
    {
        properties["size"] = VectorSchema(3);
        return shape;
    }
    properties["radius"] = length;
    if (name == "capsule")
    {
        properties["height"] = length;
        properties["direction"] = {{"enum", {"x", "y", "z"}}};
    }
    return shape;
}

Json ColliderSchema()
{
    Json schema{{"type", "object"},
                {"properties", {{"type", {{"enum", k_ColliderTypes}}}, {"enabled", BoolSchema()}}},
                {"allOf", Json::array()}};
    for (const std::string_view type : k_ColliderTypes)
    {
        // Without a type it is a box: a condition on a key that is not there holds.
        Json isThis{{"properties", {{"type", {{"const", type}}}}}};
        if (type != "box")
        {
            isThis["required"] = {"type"};
        }
        schema["allOf"].push_back({{"if", std::move(isThis)}, {"then", ShapeSchema(type)}});
    }
    return schema;
}

Json VolumeSchema()
{
    Json schema = MapSchema({
        {"name", TextSchema()},
        {"profile", Described(TextSchema(), "A *.profile.yaml or a Unity .asset file")},
        {"enabled", BoolSchema()},
        {"isGlobal", BoolSchema()},
        {"priority", Described(NumberSchema(), "The higher one wins")},
        {"weight", NumberSchema(k_Weights)},
        {"blendDistance", Described(NumberSchema(k_Lengths), "Metres")},
        {"layer", LayerIndexSchema()},
        {"colliders", ListSchema(ColliderSchema())},
    });
    AddTransform(schema);
    schema["required"] = {"profile"};
    return schema;
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
        {"turn", Described(VectorSchema(3), "Euler degrees a second on top of the rotation")},
        {"children", ListSchema({{"$ref", "#/$defs/object"}})},
    });
    AddTransform(schema);
    schema["required"] = {"name"};
    return schema;
}

Json SizeSchema()
{
    return {{"type", "array"},
            {"items", IntegerSchema(k_PictureSizes)},
            {"minItems", 2},
            {"maxItems", 2},
            {"description", "Width and height in pixels"}};
}

} // namespace

Json SceneSchema(const FeatureRegistry& features)
{
    Json renderer = MapSchema(
        {{"rendererData", TextSchema()}, {"features", ListSchema(FeatureSchema(features))}});
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
