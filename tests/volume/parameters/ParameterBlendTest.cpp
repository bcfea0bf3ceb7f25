#include "parameters/AllParameters.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace limn
{

namespace
{

constexpr std::array<float, 7> k_Factors{-1.0f, 0.0f, 1e-7f, 0.25f, 0.5f, 1.0f, 2.0f};

template <typename Parameter, typename T = typename Parameter::ValueType>
T Blend(Parameter& result, const T& from, const T& to, float t)
{
    Parameter source{nullptr, "source", from};
    Parameter target{nullptr, "target", to};
    VolumeParameter& base = result;
    base.Interp(source, target, t);
    return result.value();
}

template <typename Parameter, typename T = typename Parameter::ValueType>
T Blend(const T& from, const T& to, float t)
{
    Parameter result{nullptr, "result", from};
    return Blend(result, from, to, t);
}

template <typename Parameter, typename T = typename Parameter::ValueType>
void ExpectSwitch(const T& from, const T& to)
{
    const std::array<bool, 7> isTarget{false, false, true, true, true, true, true};
    for (std::size_t i = 0; i < k_Factors.size(); ++i)
    {
        EXPECT_TRUE(Blend<Parameter>(from, to, k_Factors[i]) == (isTarget[i] ? to : from))
            << "t = " << k_Factors[i];
        EXPECT_TRUE(Blend<Parameter>(to, from, k_Factors[i]) == (isTarget[i] ? from : to))
            << "t = " << k_Factors[i];
    }
    EXPECT_TRUE(Blend<Parameter>(from, to, std::numeric_limits<float>::quiet_NaN()) == from);
}

TextureReference Named(const std::string& path)
{
    return {{.path = path}, nullptr};
}

TEST(ParameterBlend, SwitchesEveryNoInterpAndReferenceTypeAtAnyFactorAboveZero)
{
    ExpectSwitch<BoolParameter>(false, true);
    ExpectSwitch<LayerMaskParameter>(LayerMask(1), LayerMask(6));
    ExpectSwitch<RenderingLayerMaskParameter>(RenderingLayerMask(1), RenderingLayerMask(6));
    ExpectSwitch<NoInterpIntParameter>(3, 8);
    ExpectSwitch<UIntParameter>(3u, 4294967295u);
    ExpectSwitch<NoInterpFloatParameter>(3.0f, 8.0f);
    ExpectSwitch<NoInterpColorParameter>(Color::red, Color::green);
    ExpectSwitch<NoInterpVector2Parameter>({1.0f, 2.0f}, {3.0f, 4.0f});
    ExpectSwitch<NoInterpVector3Parameter>({1.0f, 2.0f, 3.0f}, {4.0f, 5.0f, 6.0f});
    ExpectSwitch<NoInterpVector4Parameter>({1.0f, 2.0f, 3.0f, 4.0f}, {5.0f, 6.0f, 7.0f, 8.0f});
    ExpectSwitch<TextureParameter>(Named("a.png"), Named("b.png"));
    ExpectSwitch<NoInterpTextureParameter>(Named("a.png"), Named("b.png"));
    ExpectSwitch<Texture2DParameter>(Named("a.png"), Named("b.png"));
    ExpectSwitch<Texture3DParameter>(Named("a.png"), Named("b.png"));
    ExpectSwitch<RenderTextureParameter>(Named("a.png"), Named("b.png"));
    ExpectSwitch<NoInterpRenderTextureParameter>(Named("a.png"), Named("b.png"));
    ExpectSwitch<CubemapParameter>(Named("a.png"), Named("b.png"));
    ExpectSwitch<NoInterpCubemapParameter>(Named("a.png"), Named("b.png"));
    ExpectSwitch<MaterialParameter>({{.path = "a"}, nullptr}, {{.path = "b"}, nullptr});
    ExpectSwitch<TextureCurveParameter>(TextureCurve({}, 1.0f, false, 1.0f),
                                        TextureCurve({}, 2.0f, false, 1.0f));
}

TEST(ParameterBlend, SwitchesLimitedNoInterpTypesWithoutClamping)
{
    const std::array<int, 7> expected{-50, -50, 50, 50, 50, 50, 50};
    NoInterpMinIntParameter minInt{nullptr, "x", 0, 0};
    NoInterpMaxIntParameter maxInt{nullptr, "x", 0, 9};
    NoInterpClampedIntParameter clampedInt{nullptr, "x", 0, 0, 9};
    NoInterpMinFloatParameter minFloat{nullptr, "x", 0.0f, 0.0f};
    NoInterpMaxFloatParameter maxFloat{nullptr, "x", 0.0f, 9.0f};
    NoInterpClampedFloatParameter clampedFloat{nullptr, "x", 0.0f, 0.0f, 9.0f};
    NoInterpFloatRangeParameter pair{nullptr, "x", {0.0f, 0.0f}, 0.0f, 9.0f};
    for (std::size_t i = 0; i < k_Factors.size(); ++i)
    {
        const float t = k_Factors[i];
        const auto number = static_cast<float>(expected[i]);
        minInt.Interp(-50, 50, t);
        maxInt.Interp(-50, 50, t);
        clampedInt.Interp(-50, 50, t);
        minFloat.Interp(-50.0f, 50.0f, t);
        maxFloat.Interp(-50.0f, 50.0f, t);
        clampedFloat.Interp(-50.0f, 50.0f, t);
        pair.Interp({-50.0f, -50.0f}, {50.0f, 50.0f}, t);
        EXPECT_EQ(minInt.value(), expected[i]) << "t = " << t;
        EXPECT_EQ(maxInt.value(), expected[i]) << "t = " << t;
        EXPECT_EQ(clampedInt.value(), expected[i]) << "t = " << t;
        EXPECT_EQ(minFloat.value(), number) << "t = " << t;
        EXPECT_EQ(maxFloat.value(), number) << "t = " << t;
        EXPECT_EQ(clampedFloat.value(), number) << "t = " << t;
        EXPECT_EQ(pair.value(), glm::vec2(number)) << "t = " << t;
    }
}

TEST(ParameterBlend, RoundsEveryIntTypeTowardZeroWithoutClamping)
{
    const std::array<int, 7> up{-17, -3, -2, 0, 4, 11, 25};   // -3 + 14 t
    const std::array<int, 7> down{25, 11, 10, 7, 4, -3, -17}; // 11 - 14 t
    IntParameter plain{nullptr, "x", 0};
    MinIntParameter min{nullptr, "x", 0, 0};
    MaxIntParameter max{nullptr, "x", 0, 5};
    ClampedIntParameter clamped{nullptr, "x", 0, 0, 5};
    for (std::size_t i = 0; i < k_Factors.size(); ++i)
    {
        for (IntParameter* parameter : std::array<IntParameter*, 4>{&plain, &min, &max, &clamped})
        {
            parameter->Interp(-3, 11, k_Factors[i]);
            EXPECT_EQ(parameter->value(), up[i]) << parameter->typeName() << k_Factors[i];
            parameter->Interp(11, -3, k_Factors[i]);
            EXPECT_EQ(parameter->value(), down[i]) << parameter->typeName() << k_Factors[i];
        }
    }
}

TEST(ParameterBlend, BlendsEveryFloatTypeLinearlyWithoutClamping)
{
    const std::array<float, 7> up{-6.0f, 2.0f, 2.0000008f, 4.0f, 6.0f, 10.0f, 18.0f};
    const std::array<float, 7> down{18.0f, 10.0f, 9.9999992f, 8.0f, 6.0f, 2.0f, -6.0f};
    FloatParameter plain{nullptr, "x", 0.0f};
    MinFloatParameter min{nullptr, "x", 0.0f, 5.0f};
    MaxFloatParameter max{nullptr, "x", 0.0f, 5.0f};
    ClampedFloatParameter clamped{nullptr, "x", 0.0f, 5.0f, 6.0f};
    for (std::size_t i = 0; i < k_Factors.size(); ++i)
    {
        for (FloatParameter* parameter :
             std::array<FloatParameter*, 4>{&plain, &min, &max, &clamped})
        {
            parameter->Interp(2.0f, 10.0f, k_Factors[i]);
            EXPECT_FLOAT_EQ(parameter->value(), up[i]) << parameter->typeName() << k_Factors[i];
            parameter->Interp(10.0f, 2.0f, k_Factors[i]);
            EXPECT_FLOAT_EQ(parameter->value(), down[i]) << parameter->typeName() << k_Factors[i];
        }
    }
}

TEST(ParameterBlend, BlendsEveryComponentOfVectorsColoursAndRanges)
{
    const std::array<float, 7> up{-8.0f, 0.0f, 8e-7f, 2.0f, 4.0f, 8.0f, 16.0f};       // 8 t
    const std::array<float, 7> down{8.0f, 4.0f, 3.9999996f, 3.0f, 2.0f, 0.0f, -4.0f}; // 4 - 4 t
    for (std::size_t i = 0; i < k_Factors.size(); ++i)
    {
        const float t = k_Factors[i];
        FloatRangeParameter range{nullptr, "x", {0.0f, 0.0f}, 1.0f, 2.0f};
        range.Interp({0.0f, 4.0f}, {8.0f, 0.0f}, t);
        const auto v2 = Blend<Vector2Parameter>({0.0f, 4.0f}, {8.0f, 0.0f}, t);
        const auto v3 = Blend<Vector3Parameter>({0.0f, 4.0f, 0.0f}, {8.0f, 0.0f, 8.0f}, t);
        const auto v4 =
            Blend<Vector4Parameter>({0.0f, 4.0f, 0.0f, 4.0f}, {8.0f, 0.0f, 8.0f, 0.0f}, t);
        const auto color =
            Blend<ColorParameter>({0.0f, 4.0f, 0.0f, 4.0f}, {8.0f, 0.0f, 8.0f, 0.0f}, t);
        for (const float x : {range.value().x, v2.x, v3.x, v3.z, v4.x, v4.z, color.r, color.b})
        {
            EXPECT_FLOAT_EQ(x, up[i]) << "t = " << t;
        }
        for (const float y : {range.value().y, v2.y, v3.y, v4.y, v4.w, color.g, color.a})
        {
            EXPECT_FLOAT_EQ(y, down[i]) << "t = " << t;
        }
    }
}

enum class Mode
{
    Off = 0,
    Soft = 4,
    Hard = -2
};

TEST(ParameterBlend, SwitchesAnEnum)
{
    const auto make = [](Mode value)
    {
        return EnumParameter<Mode>{nullptr, "mode", value, {{"Off", Mode::Off}}};
    };
    const std::array<Mode, 7> expected{Mode::Off,  Mode::Off,  Mode::Hard, Mode::Hard,
                                       Mode::Hard, Mode::Hard, Mode::Hard};
    for (std::size_t i = 0; i < k_Factors.size(); ++i)
    {
        EnumParameter<Mode> mode = make(Mode::Soft);
        static_cast<VolumeParameter&>(mode).Interp(make(Mode::Off), make(Mode::Hard), k_Factors[i]);
        EXPECT_EQ(mode.value(), expected[i]) << "t = " << k_Factors[i];
    }
}

TEST(ParameterBlend, IsNotANumberWithAFactorThatIsNoneButLeavesIntsDefined)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(std::isnan(Blend<FloatParameter>(1.0f, 2.0f, nan)));
    EXPECT_EQ(Blend<IntParameter>(1, 2, nan), std::numeric_limits<int>::min());
}

} // namespace

} // namespace limn
