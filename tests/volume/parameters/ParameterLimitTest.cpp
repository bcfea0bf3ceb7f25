#include "Mentions.h"
#include "parameters/AllParameters.h"

#include <array>
#include <cmath>
#include <core/ThrownMessage.h>
#include <gtest/gtest.h>

namespace limn
{

namespace
{

constexpr double k_Unlimited = std::numeric_limits<double>::infinity();

template <typename Parameter, typename T>
void ExpectSetter(Parameter& parameter, T given, T expected)
{
    parameter.SetValue(given);
    EXPECT_EQ(parameter.value(), expected) << parameter.typeName() << " given " << given;
    EXPECT_FALSE(parameter.overrideState());
}

/// Limits are 2 and 6; what lies beyond them is let through where `hasMin` or `hasMax` is false.
template <typename T, typename Parameter>
void ExpectLimits(Parameter parameter, bool hasMin, bool hasMax)
{
    EXPECT_EQ(parameter.value(), T(20)) << "the constructor does not clamp";
    ExpectSetter(parameter, T(-7), hasMin ? T(2) : T(-7));
    ExpectSetter(parameter, T(2), T(2));
    ExpectSetter(parameter, T(4), T(4));
    ExpectSetter(parameter, T(6), T(6));
    ExpectSetter(parameter, T(9), hasMax ? T(6) : T(9));
    parameter.Override(T(-50));
    EXPECT_EQ(parameter.value(), T(-50)) << "Override does not clamp";
    EXPECT_TRUE(parameter.overrideState());
    parameter.Override(T(50));
    EXPECT_EQ(parameter.value(), T(50)) << "Override does not clamp";
    EXPECT_EQ(parameter.range(),
              (ValueRange{hasMin ? 2.0 : -k_Unlimited, hasMax ? 6.0 : k_Unlimited}));
}

TEST(LimitedParameter, ClampsInTheSetterAlone)
{
    ExpectLimits<int>(MinIntParameter{nullptr, "x", 20, 2}, true, false);
    ExpectLimits<int>(MaxIntParameter{nullptr, "x", 20, 6}, false, true);
    ExpectLimits<int>(ClampedIntParameter{nullptr, "x", 20, 2, 6}, true, true);
    ExpectLimits<int>(NoInterpMinIntParameter{nullptr, "x", 20, 2}, true, false);
    ExpectLimits<int>(NoInterpMaxIntParameter{nullptr, "x", 20, 6}, false, true);
    ExpectLimits<int>(NoInterpClampedIntParameter{nullptr, "x", 20, 2, 6}, true, true);
    ExpectLimits<float>(MinFloatParameter{nullptr, "x", 20.0f, 2.0f}, true, false);
    ExpectLimits<float>(MaxFloatParameter{nullptr, "x", 20.0f, 6.0f}, false, true);
    ExpectLimits<float>(ClampedFloatParameter{nullptr, "x", 20.0f, 2.0f, 6.0f}, true, true);
    ExpectLimits<float>(NoInterpMinFloatParameter{nullptr, "x", 20.0f, 2.0f}, true, false);
    ExpectLimits<float>(NoInterpMaxFloatParameter{nullptr, "x", 20.0f, 6.0f}, false, true);
    ExpectLimits<float>(NoInterpClampedFloatParameter{nullptr, "x", 20.0f, 2.0f, 6.0f}, true, true);
}

TEST(LimitedParameter, TakesWhatIsNoNumberAsUnitysMathfDoes)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    MinFloatParameter min{nullptr, "x", 3.0f, 2.0f};
    MaxFloatParameter max{nullptr, "x", 3.0f, 6.0f};
    ClampedFloatParameter clamped{nullptr, "x", 3.0f, 2.0f, 6.0f};
    min.SetValue(nan);
    max.SetValue(nan);
    clamped.SetValue(nan);
    EXPECT_EQ(min.value(), 2.0f);
    EXPECT_EQ(max.value(), 6.0f);
    EXPECT_TRUE(std::isnan(clamped.value()));
}

TEST(FloatRangeParameter, LimitsEachEndFromOneSideOnly)
{
    FloatRangeParameter blended{nullptr, "x", {-5.0f, 50.0f}, 0.0f, 10.0f};
    NoInterpFloatRangeParameter switched{nullptr, "x", {-5.0f, 50.0f}, 0.0f, 10.0f};
    EXPECT_EQ(blended.value(), glm::vec2(-5.0f, 50.0f));
    const std::array<std::array<glm::vec2, 2>, 4> cases{{{{{-1.0f, 11.0f}, {0.0f, 10.0f}}},
                                                         {{{20.0f, -20.0f}, {20.0f, -20.0f}}},
                                                         {{{7.0f, 3.0f}, {7.0f, 3.0f}}},
                                                         {{{-3.0f, 4.0f}, {0.0f, 4.0f}}}}};
    for (const auto& [given, expected] : cases)
    {
        blended.SetValue(given);
        switched.SetValue(given);
        EXPECT_EQ(blended.value(), expected);
        EXPECT_EQ(switched.value(), expected);
    }
    blended.Override({-9.0f, 90.0f});
    EXPECT_EQ(blended.value(), glm::vec2(-9.0f, 90.0f));
}

TEST(LimitedParameter, RefusesLimitsInTheWrongOrder)
{
    const auto expected = test::Mentions("'x'", "[10, 1]", "first limit");
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([] { ClampedIntParameter(nullptr, "x", 3, 10, 1); }),
        expected);
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [] { FloatRangeParameter(nullptr, "x", glm::vec2(3.0f), 10.0f, 1.0f); }),
                expected);
}

TEST(ParameterInfo, KeepsTooltipAndUnitOfEveryKindOfDeclaration)
{
    const ParameterInfo info{.tooltip = "How wide.", .unit = "pixels"};
    const BoolParameter plain{nullptr, "x", true, info};
    const ClampedIntParameter limited{nullptr, "x", 3, 1, 5, true, info};
    const ColorParameter color{nullptr, "x", Color::red, true, false, false, false, info};
    const MinFloatParameter unitOnly{nullptr, "x", 1.0f, 0.0f, {.unit = "metres"}};
    for (const VolumeParameter* parameter :
         std::array<const VolumeParameter*, 3>{&plain, &limited, &color})
    {
        EXPECT_EQ(parameter->tooltip(), "How wide.");
        EXPECT_EQ(parameter->unit(), "pixels");
    }
    EXPECT_EQ(unitOnly.tooltip(), "");
    EXPECT_EQ(unitOnly.unit(), "metres");
    EXPECT_FALSE(plain.overrideState());
    EXPECT_TRUE(limited.overrideState());
    EXPECT_TRUE(color.hdr);
    EXPECT_FALSE(color.showAlpha);
    EXPECT_FALSE(color.showEyeDropper);
}

} // namespace

} // namespace limn
