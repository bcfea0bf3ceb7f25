#include <array>
#include <cmath>
#include <core/ThrownMessage.h>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <limn/volume/AnimationCurve.h>
#include <limn/volume/CurveParameters.h>

namespace limn
{

namespace
{

constexpr float k_Infinity = std::numeric_limits<float>::infinity();
constexpr float k_NaN = std::numeric_limits<float>::quiet_NaN();

const AnimationCurve k_C0({{0, 3, 2, 2}, {4, 2, -1, -1}, {7, 2.6f, -1, -1}});
const AnimationCurve k_C1({{-1, 3, 2, 2}, {4, 2, 3, 3}, {5, 2.6f, 0, 0}, {9, 2.6f, -5, -5}});
const AnimationCurve k_C2({{0, 1, -1, 3}, {4, 6, -9, -2}, {7, 5.2f, -3, -4}});
const AnimationCurve k_C3({{11, 1, -1, 3}, {14, 6, -9, -2}, {17, 5.2f, -3, -4}});

/// The blend of two keys by the Bernstein form, which has nothing in common with powers of time.
double Reference(const AnimationCurve& curve, double time)
{
    const auto keys = curve.keys();
    if (time <= static_cast<double>(keys.front().time))
    {
        return static_cast<double>(keys.front().value);
    }
    for (std::size_t i = 1; i < keys.size(); ++i)
    {
        const auto end = static_cast<double>(keys[i].time);
        if (time < end)
        {
            const double dx = end - static_cast<double>(keys[i - 1].time);
            const double u = 1.0 - (end - time) / dx;
            const double v = 1.0 - u;
            const auto first = static_cast<double>(keys[i - 1].value);
            const auto last = static_cast<double>(keys[i].value);
            const double second = first + static_cast<double>(keys[i - 1].outTangent) * dx / 3.0;
            const double third = last - static_cast<double>(keys[i].inTangent) * dx / 3.0;
            return v * v * v * first + 3.0 * v * v * u * second + 3.0 * v * u * u * third +
                   u * u * u * last;
        }
    }
    return static_cast<double>(keys.back().value);
}

void ExpectBlend(const AnimationCurve& from, const AnimationCurve& to, float t)
{
    AnimationCurve result = from;
    KeyframeUtility::InterpAnimationCurve(result, to, t);
    for (int i = 0; i <= 100; ++i)
    {
        const float time = -5.0f + 0.25f * static_cast<float>(i);
        const auto at = static_cast<double>(time);
        const double expected = Reference(from, at) +
                                (Reference(to, at) - Reference(from, at)) * static_cast<double>(t);
        EXPECT_NEAR(static_cast<double>(result.Evaluate(time)), expected, 1e-5) << "at " << time;
    }
}

TEST(KeyframeUtility, BlendsCurvesAsTheirValuesBlend)
{
    ExpectBlend(k_C0, k_C1, 0.25f); // mixed
    ExpectBlend(k_C1, k_C2, 0.25f); // mixed
    ExpectBlend(k_C0, k_C2, 0.25f); // equal key times
    ExpectBlend(k_C0, k_C3, 0.25f); // no overlap
    ExpectBlend(k_C3, k_C0, 0.5f);
}

TEST(KeyframeUtility, MergesKeysOfEqualTimes)
{
    AnimationCurve equal = k_C0;
    KeyframeUtility::InterpAnimationCurve(equal, k_C2, 0.25f);
    EXPECT_EQ(equal.length(), 3);
    AnimationCurve mixed = k_C0;
    KeyframeUtility::InterpAnimationCurve(mixed, k_C1, 0.25f);
    EXPECT_EQ(mixed.length(), 6); // -1, 0, 4, 5, 7, 9
}

TEST(KeyframeUtility, StaysOrCopiesAtTheEndsOfTheFactorAndWithoutKeys)
{
    const auto blend = [](AnimationCurve from, const AnimationCurve& to, float t)
    {
        KeyframeUtility::InterpAnimationCurve(from, to, t);
        return from;
    };
    for (const float t : {-1.0f, 0.0f, k_NaN})
    {
        EXPECT_EQ(blend(k_C0, k_C1, t), k_C0);
    }
    for (const float t : {1.0f, 2.0f})
    {
        EXPECT_EQ(blend(k_C0, k_C1, t), k_C1);
    }
    EXPECT_EQ(blend(k_C0, AnimationCurve(), 0.5f), k_C0);
    EXPECT_EQ(blend(AnimationCurve(), k_C1, 1e-7f), k_C1);
}

TEST(KeyframeUtility, BlendsWeightsAndKeepsTheModeOfTheFirst)
{
    AnimationCurve from({{0, 0, 0, 0, 0.5f, 1.0f, WeightedMode::In}});
    const AnimationCurve to({{0, 4, 9, 9, 1.5f, 3.0f, WeightedMode::Both}});
    KeyframeUtility::InterpAnimationCurve(from, to, 0.25f);
    // The only key is the first and the last: nothing bends on either side.
    EXPECT_EQ(from, AnimationCurve({{0, 1, 0, 0, 0.75f, 1.5f, WeightedMode::In}}));
}

TEST(AnimationCurve, GoesThroughAHermiteCubicBetweenKeys)
{
    for (const AnimationCurve& curve : {k_C0, k_C1, k_C2, k_C3})
    {
        for (int i = 0; i <= 100; ++i)
        {
            const float time = -5.0f + 0.25f * static_cast<float>(i);
            EXPECT_NEAR(static_cast<double>(curve.Evaluate(time)),
                        Reference(curve, static_cast<double>(time)), 1e-6);
        }
    }
    EXPECT_EQ(AnimationCurve().Evaluate(3.0f), 0.0f);
}

TEST(AnimationCurve, TakesTheLastOfKeysOfEqualTime)
{
    const AnimationCurve curve({{0, 1}, {2, 5}, {2, 7}, {2, 9}, {4, 9}});
    EXPECT_EQ(curve.Evaluate(2.0f), 9.0f);
    EXPECT_LT(curve.Evaluate(1.999f), 5.0f);
    AnimationCurve blended = curve;
    KeyframeUtility::InterpAnimationCurve(blended, AnimationCurve({{2, 1}, {2, 1}}), 0.5f);
    EXPECT_EQ(blended.length(), 5);
    EXPECT_EQ(blended.Evaluate(2.0f), 5.0f);
    for (int i = 0; i <= 100; ++i)
    {
        EXPECT_TRUE(std::isfinite(blended.Evaluate(static_cast<float>(i) * 0.05f - 0.5f)));
    }
}

TEST(AnimationCurve, WaitsAlongAVerticalTangent)
{
    const AnimationCurve stepped({{0, 1, 0, k_Infinity}, {2, 5, 0, 0}, {4, 7, -k_Infinity, 0}});
    EXPECT_EQ(stepped.Evaluate(0.0f), 1.0f);
    EXPECT_EQ(stepped.Evaluate(1.9f), 1.0f);
    EXPECT_EQ(stepped.Evaluate(2.0f), 5.0f);
    EXPECT_EQ(stepped.Evaluate(3.9f), 5.0f);
    EXPECT_EQ(stepped.Evaluate(4.0f), 7.0f);
}

TEST(KeyframeUtility, KeepsVerticalTangentsAndMakesNoNaN)
{
    const AnimationCurve up({{0, 1, 0, k_Infinity}, {2, 5, k_Infinity, 0}});
    const AnimationCurve down({{0, 3, 0, -k_Infinity}, {1, 4, 1, 1}, {2, 5, -k_Infinity, 0}});
    for (const float t : {1e-7f, 0.25f, 0.5f, 0.999f})
    {
        AnimationCurve blended = up;
        KeyframeUtility::InterpAnimationCurve(blended, down, t);
        ASSERT_EQ(blended.length(), 3);
        EXPECT_EQ(blended.keys()[0].outTangent, k_Infinity);
        for (int i = 0; i <= 100; ++i)
        {
            EXPECT_TRUE(std::isfinite(blended.Evaluate(static_cast<float>(i) * 0.03f - 0.5f)));
        }
    }
}

TEST(AnimationCurve, IsItsFirstValueAtATimeThatIsNoNumberAndItsEndsAtInfinity)
{
    EXPECT_EQ(k_C0.Evaluate(k_NaN), 3.0f);
    EXPECT_EQ(k_C0.Evaluate(-k_Infinity), 3.0f);
    EXPECT_EQ(k_C0.Evaluate(k_Infinity), 2.6f);
}

TEST(KeyframeUtility, BlendsAHundredThousandKeys)
{
    std::vector<Keyframe> even;
    std::vector<Keyframe> odd;
    for (int i = 0; i < 100000; ++i)
    {
        even.push_back({static_cast<float>(2 * i), 1.0f});
        odd.push_back({static_cast<float>(2 * i + 1), 5.0f});
    }
    AnimationCurve blended(even);
    KeyframeUtility::InterpAnimationCurve(blended, AnimationCurve(odd), 0.25f);
    EXPECT_EQ(blended.length(), 200000);
    EXPECT_EQ(blended.Evaluate(99999.5f), 2.0f);
    EXPECT_EQ(blended.Evaluate(1e9f), 2.0f);
}

TEST(AnimationCurve, AddsKeysInOrderAndNoneAtATimeThatIsTaken)
{
    AnimationCurve curve({{4, 2}, {0, 1}});
    EXPECT_EQ(curve.keys()[0].time, 0.0f);
    EXPECT_EQ(curve.AddKey({2, 9}), 1);
    EXPECT_EQ(curve.AddKey({4, 9}), -1);
    EXPECT_EQ(curve.AddKey({5, 9}), 3);
    curve.RemoveKey(0);
    EXPECT_EQ(curve.length(), 3);
    EXPECT_EQ(curve.keys()[0].time, 2.0f);
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { curve.RemoveKey(3); }),
              "a curve of 3 keys has no key 3");
}

/// Two parameters of which one is set from or blended with the other; afterwards keys are changed
/// on one side. No side ever sees the other's change.
struct SharedKeys : testing::Test
{
    AnimationCurve two{{{0, 0}, {1, 1}}};
    AnimationCurveParameter first{nullptr, "first", two};
    AnimationCurveParameter second{nullptr, "second", AnimationCurve({{0, 5}, {1, 6}})};

    static void Grow(AnimationCurveParameter& parameter, int count)
    {
        AnimationCurve curve = parameter.value();
        for (int i = 0; i < count; ++i)
        {
            curve.AddKey({10.0f + static_cast<float>(i), 1.0f});
        }
        parameter.SetValue(curve);
    }
    void ExpectLengths(int a, int b) const
    {
        EXPECT_EQ(first.value().length(), a);
        EXPECT_EQ(second.value().length(), b);
        EXPECT_EQ(two.length(), 2);
    }
};

TEST_F(SharedKeys, AreNotSharedWithTheCurveOfTheConstructor)
{
    two.AddKey({9, 9});
    EXPECT_EQ(first.value().length(), 2);
}

TEST_F(SharedKeys, AreNotSharedAfterSetValueWhenTheSourceGrows)
{
    first.SetValue(static_cast<const VolumeParameter&>(second));
    Grow(second, 1);
    ExpectLengths(2, 3);
}

TEST_F(SharedKeys, AreNotSharedAfterSetValueWhenTheCopyGrows)
{
    first.SetValue(static_cast<const VolumeParameter&>(second));
    Grow(first, 2);
    ExpectLengths(4, 2);
}

TEST_F(SharedKeys, AreNotSharedAfterAFullBlend)
{
    first.Interp(first.value(), second.value(), 1.0f);
    Grow(second, 2);
    ExpectLengths(2, 4);
    Grow(first, 2);
    ExpectLengths(4, 4);
}

TEST_F(SharedKeys, AreNotSharedAfterAPartialBlend)
{
    first.Interp(first.value(), second.value(), 0.5f);
    EXPECT_EQ(first.value().keys()[0].value, 2.5f);
    EXPECT_EQ(second.value().keys()[0].value, 5.0f);
    Grow(first, 1);
    ExpectLengths(3, 2);
}

TEST_F(SharedKeys, AreNotSharedAfterABlendOfNothingOrOntoTheTarget)
{
    first.Interp(first.value(), second.value(), -1.0f);
    ExpectLengths(2, 2);
    EXPECT_EQ(first.value(), two);
    second.Interp(first.value(), second.value(), 0.5f);
    EXPECT_EQ(second.value().keys()[0].value, 2.5f);
    Grow(second, 1);
    ExpectLengths(2, 3);
}

/// The curve of two keys by the definition: the Bezier's point at `u`.
glm::dvec2 BezierPoint(double outWeight, double outSlope, double inWeight, double inSlope, double u)
{
    // From (0, 0) to (2, 1).
    const glm::dvec2 second(2.0 * outWeight, 2.0 * outWeight * outSlope);
    const glm::dvec2 third(2.0 - 2.0 * inWeight, 1.0 - 2.0 * inWeight * inSlope);
    const glm::dvec2 a = glm::mix(glm::dvec2(0.0), second, u);
    const glm::dvec2 b = glm::mix(second, third, u);
    const glm::dvec2 c = glm::mix(third, glm::dvec2(2.0, 1.0), u);
    return glm::mix(glm::mix(a, b, u), glm::mix(b, c, u), u);
}

TEST(AnimationCurve, BendsByTheWeightsOfItsTangents)
{
    struct Case
    {
        WeightedMode left;
        WeightedMode right;
        double out;
        double in;
    };
    const double third = 1.0 / 3.0;
    for (const Case& c : {Case{WeightedMode::Out, WeightedMode::In, 0.75, 0.5},
                          Case{WeightedMode::Both, WeightedMode::Both, 0.75, 0.5},
                          Case{WeightedMode::Out, WeightedMode::Out, 0.75, third},
                          Case{WeightedMode::In, WeightedMode::In, third, 0.5}})
    {
        const AnimationCurve curve({{0.0f, 0.0f, 0.0f, 3.0f, 0.125f, 0.75f, c.left},
                                    {2.0f, 1.0f, -2.0f, 0.0f, 0.5f, 0.125f, c.right}});
        for (int i = 0; i <= 16; ++i)
        {
            const glm::dvec2 point = BezierPoint(c.out, 3.0, c.in, -2.0, i / 16.0);
            EXPECT_NEAR(point.y, static_cast<double>(curve.Evaluate(static_cast<float>(point.x))),
                        1e-5);
        }
    }
}

TEST(AnimationCurve, WithWeightsOfAThirdIsTheOneWithoutWeights)
{
    const AnimationCurve plain({{0, 3, 2, 2}, {4, 2, -1, -1}});
    const float third = 1.0f / 3.0f;
    const AnimationCurve weighted({{0, 3, 2, 2, third, third, WeightedMode::Both},
                                   {4, 2, -1, -1, third, third, WeightedMode::Both}});
    for (int i = -4; i <= 20; ++i)
    {
        const float time = 0.25f * static_cast<float>(i);
        EXPECT_NEAR(plain.Evaluate(time), weighted.Evaluate(time), 1e-6f) << time;
    }
}

TEST(AnimationCurve, TakesAnyWeightAndTangentWithoutANaN)
{
    for (const float weight : {-5.0f, 0.0f, 1.0f, 7.0f, k_Infinity})
    {
        for (const float tangent : {0.0f, 1e30f, -k_Infinity})
        {
            const AnimationCurve curve({{0, 1, 0, tangent, weight, weight, WeightedMode::Both},
                                        {1, 2, tangent, 0, weight, weight, WeightedMode::Both}});
            for (const float time : {-1.0f, 0.0f, 0.5f, 1.0f, 2.0f})
            {
                EXPECT_TRUE(std::isfinite(curve.Evaluate(time))) << weight << " " << tangent;
            }
        }
    }
}

TEST(AnimationCurve, WrapsTimeOutsideItsKeys)
{
    AnimationCurve ramp({{1, 10, 1, 1}, {5, 14, 1, 1}}); // value = time + 9
    EXPECT_EQ(WrapMode::ClampForever, ramp.preWrapMode());
    ramp.SetPreWrapMode(WrapMode::Loop);
    ramp.SetPostWrapMode(WrapMode::PingPong);
    EXPECT_FLOAT_EQ(13.5f, ramp.Evaluate(0.5f));   // 4.5
    EXPECT_FLOAT_EQ(11.0f, ramp.Evaluate(-10.0f)); // 2
    EXPECT_FLOAT_EQ(13.0f, ramp.Evaluate(6.0f));   // 4
    EXPECT_FLOAT_EQ(10.0f, ramp.Evaluate(9.0f));   // 1, where it turns
    EXPECT_FLOAT_EQ(12.0f, ramp.Evaluate(11.0f));  // 3
    ramp.SetPostWrapMode(WrapMode::Loop);
    EXPECT_FLOAT_EQ(14.0f, ramp.Evaluate(5.0f)); // the end itself is inside
    EXPECT_FLOAT_EQ(11.0f, ramp.Evaluate(6.0f));
    EXPECT_EQ(14.0f, ramp.Evaluate(k_Infinity));
    EXPECT_EQ(10.0f, ramp.Evaluate(-k_Infinity));
    EXPECT_EQ(10.0f, ramp.Evaluate(k_NaN));
    for (const WrapMode mode : {WrapMode::Once, WrapMode::Default, WrapMode::ClampForever})
    {
        ramp.SetPostWrapMode(mode);
        EXPECT_EQ(WrapMode::ClampForever, ramp.postWrapMode());
        EXPECT_EQ(14.0f, ramp.Evaluate(6.0f));
    }
    AnimationCurve single({{1, 10}});
    single.SetPostWrapMode(WrapMode::Loop);
    EXPECT_EQ(10.0f, single.Evaluate(100.0f));
}

TEST(AnimationCurve, SmoothsTheTangentsOfAKeyThatIsAddedByTimeAndValue)
{
    AnimationCurve curve;
    EXPECT_EQ(0, curve.AddKey(0.0f, 1.0f));
    EXPECT_EQ(0.0f, curve.keys()[0].outTangent);
    EXPECT_EQ(1, curve.AddKey(4.0f, 9.0f)); // slope 2
    EXPECT_EQ(2.0f, curve.keys()[1].inTangent);
    EXPECT_EQ(1, curve.AddKey(1.0f, 6.0f)); // slopes 5 and 1
    EXPECT_EQ(3.0f, curve.keys()[1].inTangent);
    EXPECT_EQ(3.0f, curve.keys()[1].outTangent);
    EXPECT_EQ(-1, curve.AddKey(1.0f, 7.0f));
    curve.SmoothTangents(1, 1.0f);
    EXPECT_EQ(5.0f, curve.keys()[1].inTangent);
    curve.SmoothTangents(1, -1.0f);
    EXPECT_EQ(1.0f, curve.keys()[1].outTangent);
    curve.SmoothTangents(0, 0.0f);
    EXPECT_EQ(5.0f, curve.keys()[0].outTangent);
    EXPECT_EQ("a curve of 3 keys has no key 3",
              test::ThrownMessage<ContractError>([&] { curve.SmoothTangents(3, 0.0f); }));
}

TEST(AnimationCurve, SmoothsTangentsBetweenValuesWhoseDifferenceIsNoFloat)
{
    AnimationCurve curve({{0, -3e38f}, {1e5f, 3e38f}, {2e5f, -3e38f}});
    curve.SmoothTangents(0, 0.0f);
    EXPECT_FLOAT_EQ(6e33f, curve.keys()[0].outTangent);
    curve.SmoothTangents(1, 0.0f); // as steep on both sides
    EXPECT_EQ(0.0f, curve.keys()[1].inTangent);
    curve.SmoothTangents(1, 1.0f);
    EXPECT_FLOAT_EQ(6e33f, curve.keys()[1].inTangent);
}

} // namespace

} // namespace limn
