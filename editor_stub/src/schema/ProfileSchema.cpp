#include "schema/Schemas.h"
#include "settings/Keys.h"

#include <algorithm>

namespace limn
{

namespace
{

Json ObjectSchema(const VolumeParameter& parameter);

/// The schema of a type by its name, without what all parameters have.
Json TypeSchema(const VolumeParameter& parameter)
{
    std::string type(parameter.typeName());
    type = type.starts_with("NoInterp") ? type.substr(8) : type;
    const ValueRange range = parameter.range().value_or(ValueRange{});
    const auto isOneOf = [&type](std::initializer_list<std::string_view> names)
    {
        return std::find(names.begin(), names.end(), type) != names.end();
    };
    if (type == "Bool")
    {
        return BoolSchema();
    }
    if (isOneOf({"Int", "MinInt", "MaxInt", "ClampedInt"}))
    {
        return IntegerSchema(range);
    }
    if (type == "UInt")
    {
        return IntegerSchema(k_LayerBits);
    }
    if (isOneOf({"Float", "MinFloat", "MaxFloat", "ClampedFloat"}))
    {
        return NumberSchema(range);
    }
    if (type == "Color")
    {
        return ColorSchema();
    }
    if (isOneOf({"Vector2", "FloatRange"}))
    {
        return VectorSchema(2);
    }
    if (isOneOf({"Vector3", "Vector4"}))
    {
        return VectorSchema(type == "Vector3" ? 3 : 4);
    }
    if (isOneOf({"LayerMask", "RenderingLayerMask"}))
    {
        return LayerMaskSchema();
    }
    if (type == "Enum")
    {
        return EnumSchema(parameter.valueNames());
    }
    if (type == "AnimationCurve")
    {
        return AnimationCurveSchema();
    }
    if (type == "TextureCurve")
    {
        return TextureCurveSchema();
    }
    if (isOneOf({"Texture", "Texture2D", "Texture3D", "RenderTexture", "Cubemap", "Material"}))
    {
        return ReferenceSchema();
    }
    // A type that a program declares itself: its loader knows more than a schema can say.
    return parameter.parameters().empty() ? Json::object() : ObjectSchema(parameter);
}

Json ParameterSchema(const VolumeParameter& parameter)
{
    Json schema = TypeSchema(parameter);
    const std::string unit = parameter.unit().empty() ? "" : " (" + parameter.unit() + ")";
    if (!parameter.tooltip().empty() || !unit.empty())
    {
        schema["description"] = parameter.tooltip() + unit;
    }
    const std::string text = parameter.ValueText();
    if (!text.empty())
    {
        schema["default"] = ToJson(ParseYaml(text, parameter.name()).front());
    }
    return schema;
}

Json ObjectSchema(const VolumeParameter& parameter)
{
    Json schema = MapSchema(Json::object());
    for (const VolumeParameter* inner : parameter.parameters())
    {
        AddProperty(schema, inner->name(), ParameterSchema(*inner));
    }
    return schema;
}

Json ComponentSchema(const VolumeComponent& component)
{
    Json schema = MapSchema(Json::object());
    schema["type"] = {"object", "null"};
    schema["properties"]["active"] = BoolSchema();
    schema["properties"]["active"]["default"] = true;
    schema["properties"]["active"]["description"] = "false: the component is ignored altogether";
    for (const VolumeParameter* parameter : component.parameters())
    {
        AddProperty(schema, parameter->name(), ParameterSchema(*parameter));
    }
    return schema;
}

} // namespace

Json ProfileSchema(const VolumeComponentRegistry& registry)
{
    Json schema = MapSchema(Json::object());
    for (const auto& entry : registry.entries())
    {
        schema["properties"][entry->name] = ComponentSchema(*entry->defaults);
    }
    return RootSchema("limn volume profile", schema);
}

} // namespace limn
