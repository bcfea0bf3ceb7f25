#include "parameters/AllParameters.h"

#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <memory>

namespace limn
{

namespace
{

enum class ExtremeMode
{
    Off = -3,
    Soft = 0,
    Hard = 2147483647
};

struct Inner : VolumeComponent
{
    FloatParameter size{this, "size", 1.0f};
    AnimationCurveParameter curve{this, "curve", {}};
};

constexpr float k_Greatest = std::numeric_limits<float>::max();
constexpr float k_Least = std::numeric_limits<float>::denorm_min();
constexpr int k_GreatestInt = std::numeric_limits<int>::max();
constexpr int k_LeastInt = std::numeric_limits<int>::min();

// Three values of each type of value, extremes among them.

std::array<bool, 3> Values(bool)
{
    return {true, false, true};
}
std::array<int, 3> Values(int)
{
    return {k_LeastInt, 0, k_GreatestInt};
}
std::array<std::uint32_t, 3> Values(std::uint32_t)
{
    return {0u, 1u, std::numeric_limits<std::uint32_t>::max()};
}
std::array<float, 3> Values(float)
{
    return {-k_Greatest, k_Least, 0.1f};
}
std::array<Color, 3> Values(Color)
{
    return {{{k_Greatest, -k_Greatest, 0.0f, k_Least}, {0.1f, 0.2f, 0.3f, 0.4f}, Color::white}};
}
std::array<glm::vec2, 3> Values(glm::vec2)
{
    return {glm::vec2(-k_Greatest, k_Greatest), glm::vec2(k_Least, 0.0f), glm::vec2(0.1f, 0.7f)};
}
std::array<glm::vec3, 3> Values(glm::vec3)
{
    return {glm::vec3(-k_Greatest), glm::vec3(k_Least, 0.0f, k_Greatest), glm::vec3(0.1f)};
}
std::array<glm::vec4, 3> Values(glm::vec4)
{
    return {glm::vec4(-k_Greatest), glm::vec4(k_Least, 0.0f, k_Greatest, 0.3f), glm::vec4(0.1f)};
}
std::array<LayerMask, 3> Values(LayerMask)
{
    return {LayerMask::Nothing(), LayerMask::Everything(), LayerMask(0x80000001u)};
}
std::array<RenderingLayerMask, 3> Values(RenderingLayerMask)
{
    return {RenderingLayerMask::Nothing(), RenderingLayerMask::Everything(), RenderingLayerMask(6)};
}
std::array<ExtremeMode, 3> Values(ExtremeMode)
{
    return {ExtremeMode::Off, ExtremeMode::Soft, ExtremeMode::Hard};
}
// Unity's form has no paths, hence guids.
template <typename Asset>
std::array<AssetReference<Asset>, 3> Values(const AssetReference<Asset>&)
{
    const std::int64_t greatest = std::numeric_limits<std::int64_t>::max();
    return {{{},
             {{.fileID = greatest, .guid = "ffffffffffffffffffffffffffffffff", .type = 3}, {}},
             {{.fileID = -greatest, .guid = "00000000000000000000000000000001", .type = 2}, {}}}};
}
std::array<AnimationCurve, 3> Values(const AnimationCurve&)
{
    const float infinity = std::numeric_limits<float>::infinity();
    AnimationCurve loop({{-k_Greatest, k_Least, infinity, -infinity},
                         {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, WeightedMode::In},
                         {0.1f, 0.3f, 0.0f, 0.0f, 0.0f, 1.0f, WeightedMode::Both}});
    loop.SetPreWrapMode(WrapMode::PingPong);
    loop.SetPostWrapMode(WrapMode::Loop);
    return {AnimationCurve(), AnimationCurve({{0.0f, 1.0f}}), loop};
}
std::array<TextureCurve, 3> Values(const TextureCurve&)
{
    const AnimationCurve curve = Values(AnimationCurve())[2];
    return {TextureCurve(), TextureCurve(curve, k_Least, true, k_Greatest),
            TextureCurve(curve, -0.1f, false, 0.0f)};
}

template <typename Parameter>
std::unique_ptr<Parameter> Make()
{
    using T = typename Parameter::ValueType;
    if constexpr (std::is_same_v<T, ExtremeMode>)
    {
        return std::make_unique<Parameter>(
            nullptr, "p", ExtremeMode::Off,
            std::initializer_list<EnumName<ExtremeMode>>{{"Off", ExtremeMode::Off},
                                                         {"Soft", ExtremeMode::Soft},
                                                         {"Hard", ExtremeMode::Hard}});
    }
    else if constexpr (std::is_constructible_v<Parameter, std::nullptr_t, const char*, T, float,
                                               float, ParameterInfo> &&
                       std::is_same_v<T, glm::vec2>)
    {
        return std::make_unique<Parameter>(nullptr, "p", T{}, -k_Greatest, k_Greatest);
    }
    else if constexpr (std::is_constructible_v<Parameter, std::nullptr_t, const char*, T, T, T>)
    {
        return std::make_unique<Parameter>(nullptr, "p", T{}, std::numeric_limits<T>::lowest(),
                                           std::numeric_limits<T>::max());
    }
    else
    {
        return std::make_unique<Parameter>(nullptr, "p", T{});
    }
}

/// A limit that lets every value through.
template <typename Parameter, typename T = typename Parameter::ValueType>
std::unique_ptr<Parameter> MakeLimited(T limit)
{
    return std::make_unique<Parameter>(nullptr, "p", T{}, limit);
}

void ReadInto(VolumeParameter& parameter, const std::string& text)
{
    const YamlNode node = *ParseYaml("key: " + text + "\n", "x.yaml").front().Find("key");
    AssetDiagnostics diagnostics("x.yaml");
    EXPECT_TRUE(parameter.ReadYaml(node, "A.b", diagnostics)) << text;
    EXPECT_TRUE(diagnostics.diagnostics().empty()) << text;
}

template <typename Parameter>
void ExpectRoundTrips(Parameter& written, Parameter& read)
{
    for (const auto& value : Values(typename Parameter::ValueType{}))
    {
        written.Override(value);
        const std::array<std::string, 2> texts{written.ValueText(), written.UnityText()};
        for (const std::string& text : texts)
        {
            ReadInto(read, text);
            EXPECT_TRUE(read.value() == value) << read.typeName() << ": " << text;
            EXPECT_EQ(texts[0], read.ValueText());
            EXPECT_EQ(texts[1], read.UnityText());
        }
    }
}

template <typename Parameter>
class EveryParameter : public testing::Test
{
};

using Parameters = testing::Types<
    BoolParameter, LayerMaskParameter, RenderingLayerMaskParameter, IntParameter,
    NoInterpIntParameter, UIntParameter, ClampedIntParameter, NoInterpClampedIntParameter,
    FloatParameter, NoInterpFloatParameter, ClampedFloatParameter, NoInterpClampedFloatParameter,
    FloatRangeParameter, NoInterpFloatRangeParameter, ColorParameter, NoInterpColorParameter,
    Vector2Parameter, NoInterpVector2Parameter, Vector3Parameter, NoInterpVector3Parameter,
    Vector4Parameter, NoInterpVector4Parameter, TextureParameter, NoInterpTextureParameter,
    Texture2DParameter, Texture3DParameter, RenderTextureParameter, NoInterpRenderTextureParameter,
    CubemapParameter, NoInterpCubemapParameter, MaterialParameter, EnumParameter<ExtremeMode>,
    AnimationCurveParameter, TextureCurveParameter>;
TYPED_TEST_SUITE(EveryParameter, Parameters);

TYPED_TEST(EveryParameter, ReadsBackWhatItWritesInBothForms)
{
    const auto written = Make<TypeParam>();
    const auto read = Make<TypeParam>();
    ExpectRoundTrips(*written, *read);
}

template <typename Parameter>
class EveryOneSidedParameter : public testing::Test
{
};

using OneSided =
    testing::Types<MinIntParameter, NoInterpMinIntParameter, MaxIntParameter,
                   NoInterpMaxIntParameter, MinFloatParameter, NoInterpMinFloatParameter,
                   MaxFloatParameter, NoInterpMaxFloatParameter>;
TYPED_TEST_SUITE(EveryOneSidedParameter, OneSided);

TYPED_TEST(EveryOneSidedParameter, ReadsBackWhatItWritesInBothForms)
{
    using T = typename TypeParam::ValueType;
    const bool isMin = MakeLimited<TypeParam>(T{})->range()->max > 0.0 &&
                       MakeLimited<TypeParam>(T{})->range()->min == 0.0;
    const T limit = isMin ? std::numeric_limits<T>::lowest() : std::numeric_limits<T>::max();
    const auto written = MakeLimited<TypeParam>(limit);
    const auto read = MakeLimited<TypeParam>(limit);
    ExpectRoundTrips(*written, *read);
}

TEST(EveryParameter, OfAnObjectReadsBackWhatItWritesInBothForms)
{
    for (std::size_t i = 0; i < 3; ++i)
    {
        ObjectParameter<Inner> written{nullptr, "p", std::make_unique<Inner>()};
        written.value()->size.Override(Values(1.0f)[i]);
        written.value()->curve.Override(Values(AnimationCurve())[i]);
        written.value()->curve.SetOverrideState(i > 0);
        for (const std::string& text : {written.ValueText(), written.UnityText()})
        {
            ObjectParameter<Inner> read{nullptr, "p", nullptr};
            ReadInto(read, text);
            EXPECT_EQ(written.ValueText(), read.ValueText());
        }
        ObjectParameter<Inner> read{nullptr, "p", nullptr};
        ReadInto(read, written.UnityText());
        EXPECT_EQ(written.UnityText(), read.UnityText());
    }
}

} // namespace

} // namespace limn
