#include "Mentions.h"
#include "Problems.h"
#include "parameters/AllParameters.h"

#include <gmock/gmock.h>

namespace limn
{

namespace
{

using test::Mentions;
using testing::ElementsAre;

std::vector<std::string> Read(VolumeParameter& parameter, const std::string& text)
{
    const YamlNode node = *ParseYaml("key: " + text + "\n", "x.yaml").front().Find("key");
    AssetDiagnostics diagnostics("x.yaml");
    const bool isRead = parameter.ReadYaml(node, "A.b", diagnostics);
    EXPECT_NE(isRead, diagnostics.hasErrors()) << text;
    return test::Texts(diagnostics.diagnostics());
}

/// Writes `parameter` both ways, as expected, and reads each back into `other`.
template <typename Parameter>
void ExpectRoundTrip(const Parameter& parameter, Parameter&& other, const std::string& limn,
                     const std::string& unity)
{
    EXPECT_EQ(parameter.ValueText(), limn);
    EXPECT_EQ(parameter.UnityText(), unity);
    const typename Parameter::ValueType before = other.value();
    for (const std::string& text : {limn, unity})
    {
        other.Override(before);
        EXPECT_THAT(Read(other, text), ElementsAre());
        EXPECT_TRUE(other.value() == parameter.value()) << other.typeName() << ": " << text;
    }
}

template <typename Parameter, typename T>
void ExpectRoundTrip(const T& value, const std::string& limn, const std::string& unity)
{
    ExpectRoundTrip(Parameter{nullptr, "b", value},
                    Parameter{nullptr, "b", typename Parameter::ValueType{}}, limn, unity);
}

TEST(ParameterYaml, OfUIntRefusesWhatIsNone)
{
    UIntParameter parameter{nullptr, "b", 7u};
    EXPECT_THAT(Read(parameter, "-1"), ElementsAre("1:6: A.b: -1 is outside [0, 4294967295]"));
    EXPECT_THAT(Read(parameter, "4294967296"),
                ElementsAre("1:6: A.b: 4294967296 is outside [0, 4294967295]"));
    EXPECT_EQ(7u, parameter.value());
}

TEST(ParameterYaml, OfRenderingLayersReadsUnitysTwoForms)
{
    RenderingLayerMaskParameter parameter{nullptr, "b", {}};
    EXPECT_THAT(Read(parameter, "257"), ElementsAre()); // VolumeParameter<uint>
    EXPECT_EQ(RenderingLayerMask(257), parameter.value());
    EXPECT_THAT(Read(parameter, "{serializedVersion: 0, m_Bits: 4294967295}"), ElementsAre());
    EXPECT_EQ(RenderingLayerMask::Everything(), parameter.value());
}

TEST(ParameterYaml, WritesAndReadsEverySimpleTypeBothWays)
{
    ExpectRoundTrip<BoolParameter>(true, "true", "1");
    ExpectRoundTrip<IntParameter>(-7, "-7", "-7");
    ExpectRoundTrip<NoInterpIntParameter>(2147483647, "2147483647", "2147483647");
    ExpectRoundTrip<UIntParameter>(4294967295u, "4294967295", "4294967295");
    ExpectRoundTrip<FloatParameter>(0.1f, "0.1", "0.1");
    ExpectRoundTrip<FloatParameter>(3.4028235e38f, "3.4028235e+38", "3.4028235e+38");
    ExpectRoundTrip<FloatParameter>(1e-45f, "1e-45", "1e-45");
    ExpectRoundTrip<NoInterpFloatParameter>(16777216.0f, "16777216", "16777216");
    ExpectRoundTrip<ColorParameter>(Color{0.0f, 1.0f, 0.25f, 1.0f}, "{r: 0, g: 1, b: 0.25, a: 1}",
                                    "{r: 0, g: 1, b: 0.25, a: 1}");
    ExpectRoundTrip<NoInterpColorParameter>(Color::clear, "{r: 0, g: 0, b: 0, a: 0}",
                                            "{r: 0, g: 0, b: 0, a: 0}");
    ExpectRoundTrip<Vector2Parameter>(glm::vec2(1.0f, -0.5f), "[1, -0.5]", "{x: 1, y: -0.5}");
    ExpectRoundTrip<Vector3Parameter>(glm::vec3(1.0f, 2.0f, 3.0f), "[1, 2, 3]",
                                      "{x: 1, y: 2, z: 3}");
    ExpectRoundTrip<Vector4Parameter>(glm::vec4(1.0f, 2.0f, 3.0f, 4.0f), "[1, 2, 3, 4]",
                                      "{x: 1, y: 2, z: 3, w: 4}");
    ExpectRoundTrip<NoInterpVector2Parameter>(glm::vec2(1.0f), "[1, 1]", "{x: 1, y: 1}");
    ExpectRoundTrip<LayerMaskParameter>(LayerMask(0xFFFFFFFFu), "4294967295",
                                        "{serializedVersion: 2, m_Bits: 4294967295}");
    ExpectRoundTrip<RenderingLayerMaskParameter>(RenderingLayerMask(5), "5",
                                                 "{serializedVersion: 0, m_Bits: 5}");
}

TEST(ParameterYaml, WritesAndReadsReferencesBothWays)
{
    const TextureReference unitys{{.fileID = 2800000, .guid = "0123abcd", .type = 3}, nullptr};
    const std::string text = "{fileID: 2800000, guid: 0123abcd, type: 3}";
    ExpectRoundTrip<TextureParameter>(unitys, text, text);
    ExpectRoundTrip<MaterialParameter>(MaterialReference{}, "\"\"", "{fileID: 0}");
    CubemapParameter sky{nullptr, "b", {{.path = "a \"b\"\\c: #d.png"}, nullptr}};
    EXPECT_EQ(sky.UnityText(), "{fileID: 0}");
    CubemapParameter other{nullptr, "b", {}};
    EXPECT_THAT(Read(other, sky.ValueText()), ElementsAre());
    EXPECT_EQ(other.value(), sky.value());
    EXPECT_THAT(Read(other, ""), ElementsAre());
    EXPECT_TRUE(other.value().location.isNull());
    EXPECT_THAT(Read(other, "[1]"),
                ElementsAre(Mentions("1:6: A.b", "sequence", "path", "{fileID: 0}")));
}

TEST(ParameterYaml, WritesAndReadsCurvesBothWays)
{
    const float infinity = std::numeric_limits<float>::infinity();
    const AnimationCurve curve(
        {{0, 1, -infinity, 0.5f}, {2, 3, 0, infinity, 0.25f, 0.5f, WeightedMode::Both}});
    const std::string limn =
        "[{time: 0, value: 1, inTangent: -Infinity, outTangent: 0.5}, {time: 2, value: 3, "
        "inTangent: 0, outTangent: Infinity, inWeight: 0.25, outWeight: 0.5, weightedMode: 3}]";
    const std::string unity =
        "{serializedVersion: 2, m_Curve: [{serializedVersion: 3, time: 0, value: 1, inSlope: "
        "-Infinity, outSlope: 0.5, tangentMode: 0, weightedMode: 0, inWeight: 0, outWeight: 0}, "
        "{serializedVersion: 3, time: 2, value: 3, inSlope: 0, outSlope: Infinity, tangentMode: "
        "0, weightedMode: 3, inWeight: 0.25, outWeight: 0.5}], m_PreInfinity: 2, m_PostInfinity: "
        "2, m_RotationOrder: 4}";
    ExpectRoundTrip<AnimationCurveParameter>(curve, limn, unity);
    ExpectRoundTrip<TextureCurveParameter>(
        TextureCurve(curve, 0.5f, true, 2.0f),
        "{keys: " + limn + ", zeroValue: 0.5, loop: true, range: 2}",
        "{<length>k__BackingField: 2, m_Loop: 1, m_ZeroValue: 0.5, m_Range: 2, m_Curve: " + unity +
            "}");
}

TEST(ParameterYaml, SaysWhatIsWrongWithACurve)
{
    AnimationCurveParameter curve{nullptr, "b", AnimationCurve({{1, 2}})};
    EXPECT_THAT(Read(curve, "3"),
                ElementsAre(Mentions("1:6: A.b", "'3'", "list of keys", "{m_Curve: [...]}")));
    EXPECT_THAT(Read(curve, "[{time: 0, value: .nan}]"),
                ElementsAre(Mentions("1:24: A.b[0].value", "'.nan'", "finite")));
    EXPECT_EQ(curve.value(), AnimationCurve({{1, 2}}));
}

TEST(ParameterYaml, ReadsALayerMaskAsBitsNameAndList)
{
    LayerMaskParameter mask{nullptr, "b", {}};
    EXPECT_THAT(Read(mask, "Everything"), ElementsAre());
    EXPECT_EQ(mask.value(), LayerMask::Everything());
    EXPECT_THAT(Read(mask, "[Default, UI, 31]"), ElementsAre());
    EXPECT_EQ(mask.value(), LayerMask(0x80000021u));
    EXPECT_THAT(Read(mask, "{m_Bits: 12}"), ElementsAre());
    EXPECT_EQ(mask.value(), LayerMask(12));
    EXPECT_THAT(Read(mask, "[]"), ElementsAre());
    EXPECT_EQ(mask.value(), LayerMask::Nothing());
    EXPECT_THAT(Read(mask, "[32]"), ElementsAre("1:7: A.b: 32 is outside [0, 31]"));
}

TEST(ParameterYaml, HoldsFilesToTheLimits)
{
    MinIntParameter min{nullptr, "b", 3, 1};
    EXPECT_THAT(Read(min, "0"), ElementsAre("1:6: A.b: 0 is outside [1, 2147483647]"));
    EXPECT_EQ(min.value(), 3);
    FloatRangeParameter range{nullptr, "b", {1.0f, 2.0f}, 0.0f, 10.0f};
    EXPECT_THAT(Read(range, "[20, -20]"), ElementsAre());
    EXPECT_THAT(Read(range, "[-1, 5]"), ElementsAre("1:6: A.b: [-1, 5] goes beyond [0, 10]"));
    EXPECT_THAT(Read(range, "{x: 0, y: 11}"), ElementsAre("1:6: A.b: [0, 11] goes beyond [0, 10]"));
    EXPECT_EQ(range.value(), glm::vec2(20.0f, -20.0f));
}

enum class NamedMode
{
    Off = 0,
    Soft = 4
};

TEST(ParameterYaml, ReadsAnEnumByNameAndNumber)
{
    EnumParameter<NamedMode> mode{nullptr,
                                  "b",
                                  NamedMode::Off,
                                  {{"Off", NamedMode::Off}, {"Soft", NamedMode::Soft}},
                                  {.tooltip = "How."}};
    EXPECT_THAT(Read(mode, "Soft"), ElementsAre());
    EXPECT_EQ(mode.value(), NamedMode::Soft);
    EXPECT_EQ(mode.ValueText(), "Soft");
    EXPECT_EQ(mode.UnityText(), "4");
    EXPECT_THAT(mode.valueNames(), ElementsAre("Off", "Soft"));
    EXPECT_THAT(Read(mode, "0"), ElementsAre());
    EXPECT_EQ(mode.value(), NamedMode::Off);
    EXPECT_THAT(Read(mode, "Hard"),
                ElementsAre(Mentions("1:6: A.b", "'Hard'", "one of", "Off (0), Soft (4)")));
}

struct Counted : VolumeComponent
{
    FloatParameter size{this, "size", 1.0f};
    IntParameter count{this, "count", 2};
};

struct Outer : VolumeComponent
{
    ObjectParameter<Counted> object{this, "object", std::make_unique<Counted>()};
};

TEST(ObjectParameter, ReadsAndWritesTheParametersOfItsObject)
{
    ObjectParameter<Counted> object{nullptr, "b", nullptr};
    EXPECT_EQ(object.ValueText(), "{}");
    EXPECT_THAT(Read(object, "{size: 4}"), ElementsAre());
    EXPECT_EQ(object.value()->size.value(), 4.0f);
    EXPECT_EQ(object.ValueText(), "{size: 4}");
    const std::string unity = "{size: {m_OverrideState: 1, m_Value: 4}, count: {m_OverrideState: "
                              "0, m_Value: 2}}";
    EXPECT_EQ(object.UnityText(), unity);
    ObjectParameter<Counted> other{nullptr, "b", std::make_unique<Counted>()};
    EXPECT_THAT(Read(other, unity), ElementsAre());
    EXPECT_EQ(other.UnityText(), unity);
}

TEST(ObjectParameter, BlendsWhatIsOverriddenWithinTheTarget)
{
    Outer state;
    Outer to;
    to.object.value()->size.Override(9.0f);
    to.object.value()->count.SetValue(50);
    to.Override(state, 0.25f);
    EXPECT_EQ(state.object.value()->size.value(), 3.0f);
    EXPECT_TRUE(state.object.value()->size.overrideState());
    EXPECT_EQ(state.object.value()->count.value(), 2);
    EXPECT_FALSE(state.object.value()->count.overrideState());
    to.object.SetValue(nullptr);
    to.Override(state, 1.0f);
    EXPECT_EQ(state.object.value()->size.value(), 3.0f);
}

TEST(ObjectParameter, IsAlwaysOverriddenAndSharesNothing)
{
    Outer first;
    first.SetAllOverridesTo(true);
    EXPECT_TRUE(first.object.value()->count.overrideState());
    first.SetAllOverridesTo(false);
    EXPECT_TRUE(first.object.overrideState());
    EXPECT_FALSE(first.object.value()->count.overrideState());
    Outer second;
    second.object.value()->size.Override(7.0f);
    first.object.SetValue(static_cast<const VolumeParameter&>(second.object));
    second.object.value()->size.Override(8.0f);
    EXPECT_EQ(first.object.value()->size.value(), 7.0f);
}

TEST(ParameterYaml, WritesAndReadsTheWrapModesOfACurve)
{
    AnimationCurve curve({{0, 1}});
    curve.SetPreWrapMode(WrapMode::Loop);
    curve.SetPostWrapMode(WrapMode::PingPong);
    ExpectRoundTrip<AnimationCurveParameter>(
        curve,
        "{keys: [{time: 0, value: 1, inTangent: 0, outTangent: 0}], preWrapMode: Loop, "
        "postWrapMode: PingPong}",
        "{serializedVersion: 2, m_Curve: [{serializedVersion: 3, time: 0, value: 1, inSlope: 0, "
        "outSlope: 0, tangentMode: 0, weightedMode: 0, inWeight: 0, outWeight: 0}], "
        "m_PreInfinity: 1, m_PostInfinity: 0, m_RotationOrder: 4}");
    AnimationCurveParameter other{nullptr, "b", {}};
    EXPECT_THAT(
        Read(other, "{keys: [], preWrapMode: Lop, wrap: 1}"),
        ElementsAre(
            Mentions("1:30: A.b.preWrapMode", "'Lop'", "one of",
                     "Loop (2), PingPong (4), ClampForever (8), Once (1), Clamp (1), Default (0)"),
            Mentions("1:35: A.b", "unknown key", "'wrap'", "preWrapMode, postWrapMode, keys")));
    EXPECT_THAT(Read(other, "{m_Curve: [], m_PreInfinity: 3}"),
                ElementsAre(Mentions("1:35: A.b.m_PreInfinity", "3", "outside", "[0, 2]")));
}

TEST(BoolParameter, HasADisplayTypeForEditors)
{
    const BoolParameter plain{nullptr, "b", true};
    EXPECT_EQ(BoolParameter::DisplayType::Checkbox, plain.displayType);
    const BoolParameter popup{nullptr, "b", true, BoolParameter::DisplayType::EnumPopup};
    EXPECT_EQ(1, static_cast<int>(popup.displayType));
}

} // namespace

} // namespace limn
