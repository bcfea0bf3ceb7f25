#include "ProfileSchema.h"

#include <gtest/gtest.h>
#include <limn/volume/AnimationCurveParameter.h>
#include <limn/volume/EnumParameter.h>
#include <limn/volume/FloatParameter.h>
#include <limn/volume/IntParameter.h>
#include <limn/volume/LayerMaskParameter.h>
#include <limn/volume/TextureParameter.h>
#include <limn/volume/VectorParameter.h>

namespace limn::test
{

namespace
{

enum class Mode
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
    EnumParameter<Mode> mode{
        this, "m_Mode", Mode::Wide, {{"Off", Mode::Off}, {"Wide", Mode::Wide}}};
    LayerMaskParameter layers{this, "m_Layers", LayerMask(1)};
    AnimationCurveParameter curve{this, "m_Curve", AnimationCurve()};
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
    EXPECT_EQ(Json::object(), key["properties"]["inTangent"]);
}

TEST(ProfileSchema, LeavesAReferenceToTheLoader)
{
    EXPECT_FALSE(Schema("texture").contains("type"));
}

} // namespace limn::test
