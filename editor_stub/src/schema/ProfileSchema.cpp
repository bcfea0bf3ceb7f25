#include "console/Texts.h"
#include "schema/Schemas.h"
#include "settings/Keys.h"

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
    if (IsIn(type, {"Vector3", "Vector4"}))
    {
        return VectorSchema(type == "Vector3" ? 3 : 4);
    }
    return type == "Bool"                                          ? BoolSchema()
           : IsIn(type, {"Int", "MinInt", "MaxInt", "ClampedInt"}) ? IntegerSchema(range)
           : type == "UInt"                                        ? IntegerSchema(k_LayerBits)
           : IsIn(type, {"Float", "MinFloat", "MaxFloat", "ClampedFloat"}) ? NumberSchema(range)
           : type == "Color"                                               ? ColorSchema()
           : IsIn(type, {"Vector2", "FloatRange"})                         ? VectorSchema(2)
           : IsIn(type, {"LayerMask", "RenderingLayerMask"})               ? LayerMaskSchema()
           : type == "Enum"           ? EnumSchema(parameter.valueNames())
           : type == "AnimationCurve" ? AnimationCurveSchema()
           : type == "TextureCurve"   ? TextureCurveSchema()
           : IsIn(type,
                  {"Texture", "Texture2D", "Texture3D", "RenderTexture", "Cubemap", "Material"})
               ? ReferenceSchema()
           // A type that a program declares itself: its loader knows more than a schema can say.
           : parameter.parameters().empty() ? Json::object()
                                            : ObjectSchema(parameter);
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
    Json active = BoolSchema();
    active["default"] = true;
    schema["properties"]["active"] =
        WithDescription(active, "Lets the component count; on unless it is set");
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
