#include "schema/Schemas.h"

#include <gtest/gtest.h>
#include <limn/volume/AssetParameters.h>
#include <limn/volume/CurveParameters.h>
#include <limn/volume/NumberParameters.h>
#include <limn/volume/ValueParameters.h>

namespace limn::test
{

namespace
{

enum class Reach
{
    Off,
    Wide
};

class Many : public VolumeComponent
{
public:
    MinIntParameter count{this, "m_Count", 3, 2};
    NoInterpMaxFloatParameter size{this, "m_Size", 0.1f, 0.7f};
    Vector3Parameter offset{this, "m_Offset", glm::vec3(1.0f, 2.0f, 0.5f)};
    EnumParameter<Reach> mode{
        this, "m_Mode", Reach::Wide, {{"Off", Reach::Off}, {"Wide", Reach::Wide}}};
    LayerMaskParameter layers{this, "m_Layers", LayerMask(1)};
    AnimationCurveParameter curve{this, "m_Curve", AnimationCurve()};
    TextureCurveParameter textureCurve{this, "m_TextureCurve", TextureCurve()};
    TextureParameter texture{this, "m_Texture", TextureReference()};
};

/// The schema of one parameter of Many.
Json Schema(const std::string& parameter)
{
    VolumeComponentRegistry registry;
    registry.Register<Many>("Many");
    return ProfileSchema(registry)["properties"]["Many"]["properties"][parameter];
}

} // namespace

TEST(ProfileSchema, GivesAOneSidedLimitAloneAndTheDefault)
{
    EXPECT_EQ(Json::parse(R"({"type": "integer", "minimum": 2, "default": 3})"), Schema("count"));
    EXPECT_EQ(Json::parse(R"({"type": "number", "maximum": 0.7, "default": 0.1})"),
              Schema("m_Size"));
}

TEST(ProfileSchema, OffersAnEnumsNames)
{
    const Json schema = Schema("mode");
    EXPECT_EQ(Json::parse(R"(["Off", "Wide"])"), schema["anyOf"][0]["enum"]);
    EXPECT_EQ("Wide", schema["default"]);
}

TEST(ProfileSchema, TakesAVectorAsListOrMap)
{
    const Json schema = Schema("m_Offset");
    EXPECT_EQ(3, schema["anyOf"][0]["minItems"]);
    EXPECT_EQ(Json::parse(R"(["x", "y", "z"])"), schema["anyOf"][1]["required"]);
}

TEST(ProfileSchema, TakesACurveAsAListOfKeys)
{
    const Json key = Schema("curve")["anyOf"][0]["items"];
    EXPECT_EQ(Json::parse(R"(["time", "value"])"), key["required"]);
    EXPECT_EQ(Json::parse(R"({"type": "number"})"), key["properties"]["inTangent"]["anyOf"][0]);
    EXPECT_EQ(false, key["additionalProperties"]);
}

TEST(ProfileSchema, TakesTheWeightsOfTangents)
{
    const Json key = Schema("curve")["anyOf"][0]["items"]["properties"];
    EXPECT_EQ(Json::parse(R"({"type": "number"})"), key["inWeight"]);
    EXPECT_EQ(Json::parse(R"({"type": "number"})"), key["outWeight"]);
    EXPECT_EQ(Json::parse(R"({"type": "integer", "minimum": 0, "maximum": 3})"),
              key["weightedMode"]);
}

TEST(ProfileSchema, TakesTheWrapModesOfACurveByNameOrInUnitysForm)
{
    const Json forms = Schema("curve")["anyOf"];
    EXPECT_EQ(Json::parse(R"(["keys"])"), forms[1]["required"]);
    for (const char* mode : {"preWrapMode", "postWrapMode"})
    {
        const Json names = forms[1]["properties"][mode]["anyOf"][0]["enum"];
        EXPECT_EQ(
            Json::parse(R"(["Loop", "PingPong", "ClampForever", "Once", "Clamp", "Default"])"),
            names);
    }
    EXPECT_EQ(false, forms[1]["additionalProperties"]);
    EXPECT_EQ(Json::parse(R"(["m_Curve"])"), forms[2]["required"]);
    EXPECT_EQ(Json::parse(R"({"type": "integer", "minimum": 0, "maximum": 2})"),
              forms[2]["properties"]["m_PreInfinity"]);
}

TEST(ProfileSchema, TakesATextureCurveWithItsKeysOrInUnitysForm)
{
    const Json schema = Schema("m_TextureCurve");
    EXPECT_EQ(Json::parse(R"(["keys"])"), schema["anyOf"][0]["required"]);
    EXPECT_EQ(Json::parse(R"({"type": "number", "minimum": 0})"),
              schema["anyOf"][0]["properties"]["range"]);
    EXPECT_EQ(Json::parse(R"(["m_Curve"])"), schema["anyOf"][1]["required"]);
}

TEST(ProfileSchema, TakesAReferenceAsAPathOrInUnitysForm)
{
    const Json schema = Schema("texture");
    EXPECT_EQ(Json::parse(R"(["string", "null"])"), schema["anyOf"][0]["type"]);
    EXPECT_EQ(Json::parse(R"(["fileID"])"), schema["anyOf"][1]["required"]);
    EXPECT_EQ(false, schema["anyOf"][1]["additionalProperties"]);
}

} // namespace limn::test
