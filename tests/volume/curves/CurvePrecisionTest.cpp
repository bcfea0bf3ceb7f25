#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <limn/volume/AnimationCurve.h>
#include <precision/RandomFloats.h>

namespace limn
{

namespace
{

using test::RandomFloats;

/// A number and the size of what it is a sum of.
struct Sum
{
    long double value;
    long double size;
};

/// The cubic by its Bernstein form, with 64 bits of mantissa; nothing in it is a power of time.
Sum ExactBetween(const Keyframe& left, const Keyframe& right, float time)
{
    const long double start = left.time;
    const long double distance = static_cast<long double>(right.time) - start;
    const long double u = (static_cast<long double>(time) - start) / distance;
    const long double v = 1 - u;
    const long double from = left.value;
    const long double to = right.value;
    const long double out = distance * static_cast<long double>(left.outTangent) / 3;
    const long double in = distance * static_cast<long double>(right.inTangent) / 3;
    const long double value = v * v * v * from + 3 * v * v * u * (from + out) +
                              3 * v * u * u * (to - in) + u * u * u * to;
    return {value, std::abs(from) + std::abs(to) + 3 * std::abs(out) + 3 * std::abs(in)};
}

Sum ExactAt(const AnimationCurve& curve, float time)
{
    const auto keys = curve.keys();
    const Keyframe* right = keys.data();
    for (; right != keys.data() + keys.size() && right->time <= time; ++right)
    {
    }
    if (right == keys.data() || right == keys.data() + keys.size())
    {
        const long double end = right == keys.data() ? right->value : right[-1].value;
        return {end, std::abs(end)};
    }
    return ExactBetween(right[-1], *right, time);
}

/// Keys at least a millisecond apart; values and slopes of many sizes.
AnimationCurve RandomCurve(RandomFloats& random)
{
    const auto anySize = [&random](float low, float high)
    {
        const float size = std::pow(10.0f, random.Between(low, high));
        return random.Below(2) == 0 ? size : -size;
    };
    std::vector<Keyframe> keys;
    float time = random.Between(-100.0f, 100.0f);
    const int count = 1 + random.Below(4);
    for (int i = 0; i < count; ++i)
    {
        keys.push_back({time, random.Below(8) == 0 ? 0.0f : anySize(-40.0f, 6.0f),
                        anySize(-6.0f, 6.0f), anySize(-6.0f, 6.0f)});
        time += std::pow(10.0f, random.Between(-2.9f, 3.0f));
    }
    return AnimationCurve(std::move(keys));
}

/// Between the keys, a float before and behind them, and on them.
float RandomTime(RandomFloats& random, const AnimationCurve& curve)
{
    const auto keys = curve.keys();
    const float key = keys[static_cast<std::size_t>(random.Below(curve.length()))].time;
    switch (random.Below(4))
    {
    case 0:
        return key;
    case 1:
        return std::nextafter(key, -1e9f);
    case 2:
        return std::nextafter(key, 1e9f);
    default:
        return random.Between(keys.front().time - 1.0f, keys.back().time + 1.0f);
    }
}

// In double: two slopes, their sum, a division by the distance and its square, and three steps of
// Horner's, each off by 2^-53 of the values and of the slopes times the distance at most; then one
// rounding to a float.
constexpr long double k_DoubleSteps = 16 * 0x1p-53L;

TEST(CurvePrecision, ACurveIsTheExactCubicRoundedOnce)
{
    RandomFloats random(31);
    double largest = 0.0;
    for (int i = 0; i < 50'000; ++i)
    {
        const AnimationCurve curve = RandomCurve(random);
        const float time = RandomTime(random, curve);
        const float value = curve.Evaluate(time);
        const Sum exact = ExactAt(curve, time);
        const long double error = std::abs(static_cast<long double>(value) - exact.value);
        const auto ulp = static_cast<long double>(test::Ulp(value));
        ASSERT_LE(error, 0.5L * ulp + k_DoubleSteps * exact.size)
            << "curve " << i << " at " << time;
        if (std::abs(exact.value) > 0x1p-20L * exact.size)
        {
            largest = std::max(largest, static_cast<double>(error / ulp));
        }
    }
    std::cout << "largest error of 50000 values of curves: " << largest << " ulp\n";
}

TEST(CurvePrecision, ABlendOfCurvesHasTheBlendOfTheirValuesAtEveryKey)
{
    RandomFloats random(32);
    double largest = 0.0;
    for (int i = 0; i < 10'000; ++i)
    {
        const AnimationCurve from = RandomCurve(random);
        const AnimationCurve to = RandomCurve(random);
        const float t = random.Share();
        AnimationCurve blended = from;
        KeyframeUtility::InterpAnimationCurve(blended, to, t);
        for (const Keyframe& key : blended.keys())
        {
            const Sum a = ExactAt(from, key.time);
            const Sum b = ExactAt(to, key.time);
            const long double share = t;
            const long double exact = a.value * (1 - share) + b.value * share;
            const long double error = std::abs(static_cast<long double>(key.value) - exact);
            // Both values are floats, and so is their blend, which is no larger than they are.
            const auto ulp = static_cast<long double>(
                test::Ulp(static_cast<float>(std::max(std::abs(a.value), std::abs(b.value)))));
            ASSERT_LE(error, ulp + k_DoubleSteps * (a.size + b.size))
                << "blend " << i << " at " << key.time;
            largest = std::max(largest, static_cast<double>(error / ulp));
        }
    }
    std::cout << "largest error of the keys of 10000 blends of curves: " << largest
              << " ulp of the larger\n";
}

} // namespace

} // namespace limn
