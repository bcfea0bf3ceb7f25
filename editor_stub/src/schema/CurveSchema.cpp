#include "schema/Schemas.h"

namespace limn
{

namespace
{

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

Json WrapModeSchema()
{
    return EnumSchema(
        std::vector<std::string>{"Loop", "PingPong", "ClampForever", "Once", "Clamp", "Default"});
}

} // namespace

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
