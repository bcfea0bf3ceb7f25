#include "parameters/AllParameters.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <limits>
#include <precision/ExactSum.h>
#include <precision/RandomFloats.h>

namespace limn
{

namespace
{

using test::ExactSum;
using test::RandomFloats;
using test::Ulp;

constexpr int k_CaseCount = 1'000'000;
constexpr int k_PerTypeCount = 50'000;
constexpr float k_Endless = std::numeric_limits<float>::infinity();

/// What is wrong with `blended` as from + (to - from) t, and by how much it is rounded. Products of
/// two floats are exact in double, and so is their sum here.
///
/// A blend a (1 - t) + b t in double rounds 1 - t, a product and the sum, each by at most 2^-53 of
/// the larger of |a| and |b|, before the one rounding to a float: half an ulp of the result and
/// 2^-51 of the larger. With t exactly 0 or 1 nothing is rounded. Between two neighbouring t the
/// blend moves by more than that where it is half way between two floats, so that it grows or falls
/// with t and never leaves the interval.
struct BlendError
{
    double error;
    double bound;

    BlendError(float from, float to, float t, float blended)
    {
        const auto a = static_cast<double>(from);
        const auto b = static_cast<double>(to);
        const auto share = static_cast<double>(t);
        const auto result = static_cast<double>(blended);
        error = std::abs(ExactSum({a, -a * share, b * share, -result}));
        bound = 0.5 * Ulp(blended) + 0x1p-51 * std::max(std::abs(a), std::abs(b));
    }
};

std::string Case(float from, float to, float t)
{
    std::ostringstream text;
    text << std::hexfloat << from << " to " << to << " at " << t;
    return text.str();
}

TEST(ParameterPrecision, ABlendIsTheExactOneRoundedOnce)
{
    RandomFloats random(1);
    FloatParameter blended{nullptr, "x", 0.0f};
    double largest = 0.0;
    int failures = 0;
    for (int i = 0; i < k_CaseCount; ++i)
    {
        const float from = random.Any();
        const float to = random.Any();
        const float t = random.Share();
        blended.Interp(from, to, t);
        const float value = blended.value();
        const BlendError found(from, to, t, value);
        const bool isWithin = value >= std::min(from, to) && value <= std::max(from, to);
        const bool isEnd = (t != 0.0f || value == from) && (t != 1.0f || value == to);
        if (!(found.error <= found.bound) || !isWithin || !isEnd)
        {
            ASSERT_LT(++failures, 10);
            ADD_FAILURE() << Case(from, to, t) << " gives " << std::hexfloat << value;
        }
        const float size = std::max(std::abs(from), std::abs(to));
        if (std::abs(value) > size * 0x1p-20f) // elsewhere the bound's second part is larger
        {
            largest = std::max(largest, found.error / Ulp(value));
        }
    }
    std::cout << "largest error of " << k_CaseCount << " blends: " << largest << " ulp\n";
}

TEST(ParameterPrecision, ABlendGrowsOrFallsWithTheFactor)
{
    RandomFloats random(2);
    FloatParameter blended{nullptr, "x", 0.0f};
    for (int i = 0; i < k_PerTypeCount; ++i)
    {
        const float from = random.Any();
        const float to = random.Any();
        float t = random.Share();
        blended.Interp(from, to, t);
        float before = blended.value();
        for (int step = 0; step < 4 && t < 1.0f; ++step)
        {
            t = std::nextafter(t, 1.0f);
            blended.Interp(from, to, t);
            ASSERT_TRUE(from < to ? blended.value() >= before : blended.value() <= before)
                << Case(from, to, t);
            before = blended.value();
        }
    }
}

/// As FloatParameter does it, component by component.
template <typename Parameter>
void ExpectAsFloats(int count)
{
    using T = typename Parameter::ValueType;
    constexpr std::size_t k_Count = sizeof(T) / sizeof(float);
    RandomFloats random(3);
    FloatParameter expected{nullptr, "x", 0.0f};
    Parameter blended{nullptr, "x", T{}};
    for (int i = 0; i < count; ++i)
    {
        std::array<float, k_Count> from{};
        std::array<float, k_Count> to{};
        std::ranges::generate(from, [&] { return random.Any(); });
        std::ranges::generate(to, [&] { return random.Any(); });
        const float t = random.Share();
        blended.Interp(std::bit_cast<T>(from), std::bit_cast<T>(to), t);
        const auto values = std::bit_cast<std::array<float, k_Count>>(blended.value());
        for (std::size_t k = 0; k < k_Count; ++k)
        {
            expected.Interp(from[k], to[k], t);
            ASSERT_EQ(std::bit_cast<std::uint32_t>(expected.value()),
                      std::bit_cast<std::uint32_t>(values[k]))
                << blended.typeName() << ": " << Case(from[k], to[k], t);
        }
    }
}

TEST(ParameterPrecision, EveryComponentBlendsAsANumberDoes)
{
    ExpectAsFloats<ColorParameter>(k_PerTypeCount);
    ExpectAsFloats<Vector2Parameter>(k_PerTypeCount);
    ExpectAsFloats<Vector3Parameter>(k_PerTypeCount);
    ExpectAsFloats<Vector4Parameter>(k_PerTypeCount);
    RandomFloats random(4);
    FloatParameter expected{nullptr, "x", 0.0f};
    MinFloatParameter least{nullptr, "x", 0.0f, 1.0f};
    MaxFloatParameter most{nullptr, "x", 0.0f, 1.0f};
    ClampedFloatParameter clamped{nullptr, "x", 0.0f, 1.0f, 2.0f};
    FloatRangeParameter range{nullptr, "x", glm::vec2(0.0f), 1.0f, 2.0f};
    for (int i = 0; i < k_PerTypeCount; ++i)
    {
        const float from = random.Any();
        const float to = random.Any();
        const float t = random.Share();
        expected.Interp(from, to, t);
        least.Interp(from, to, t);
        most.Interp(from, to, t);
        clamped.Interp(from, to, t);
        range.Interp({from, to}, {to, from}, t);
        ASSERT_EQ(expected.value(), least.value());
        ASSERT_EQ(expected.value(), most.value());
        ASSERT_EQ(expected.value(), clamped.value());
        ASSERT_EQ(expected.value(), range.value().x);
    }
}

TEST(ParameterPrecision, BothEndsAreExactForInfinitiesNaNsAndZerosToo)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    FloatParameter blended{nullptr, "x", 0.0f};
    for (const float any : {k_Endless, -k_Endless, nan, 0.0f, -0.0f, 5.0f})
    {
        for (const float end : {k_Endless, -k_Endless, 0.0f, -0.0f, 5.0f})
        {
            blended.Interp(any, end, 1.0f);
            EXPECT_EQ(std::bit_cast<std::uint32_t>(end),
                      std::bit_cast<std::uint32_t>(blended.value()))
                << any << " to " << end;
            blended.Interp(end, any, 0.0f);
            EXPECT_EQ(std::bit_cast<std::uint32_t>(end),
                      std::bit_cast<std::uint32_t>(blended.value()))
                << end << " to " << any;
        }
    }
    blended.Interp(k_Endless, k_Endless, 0.5f);
    EXPECT_EQ(k_Endless, blended.value());
    blended.Interp(-0.0f, -0.0f, 0.5f);
    EXPECT_TRUE(std::signbit(blended.value()));
}

TEST(ParameterPrecision, OutsideZeroToOneTheLineGoesOn)
{
    RandomFloats random(5);
    FloatParameter blended{nullptr, "x", 0.0f};
    for (int i = 0; i < k_PerTypeCount; ++i)
    {
        const float from = random.Between(-100.0f, 100.0f);
        const float to = random.Between(-100.0f, 100.0f);
        const float t = random.Between(-10.0f, 10.0f);
        blended.Interp(from, to, t);
        const BlendError found(from, to, t, blended.value());
        ASSERT_LE(found.error, found.bound + 0x1p-48 * 1000.0) << Case(from, to, t);
    }
}

__extension__ using Wide = __int128;

/// An int blend held against from 2^k + (to - from) m for t = m / 2^k, in integers.
struct WholeBlend
{
    Wide scaled; ///< the exact blend times 2^k
    Wide part;   ///< (to - from) t times 2^k
    int shift;

    WholeBlend(int from, int to, float t)
    {
        const int exponent = std::max(std::ilogb(t), -60);
        shift = 23 - exponent;
        const auto mantissa = static_cast<std::int64_t>(std::ldexp(static_cast<double>(t), shift));
        part = (Wide{to} - from) * mantissa;
        scaled = (Wide{from} << shift) + part;
    }
    Wide Toward0() const { return scaled / (Wide{1} << shift); }
    /// Whether it is so near to `whole` that t, being a float, cannot tell the two apart, or a
    /// double does not.
    bool Means(int whole) const
    {
        const auto size = [](Wide value)
        {
            return value < 0 ? -value : value;
        };
        const Wide ofDouble = (size(scaled) >> 52) + 1;
        return size(scaled - (Wide{whole} << shift)) <= (size(part) >> 24) + ofDouble;
    }
};

int AnyInt(RandomFloats& random)
{
    constexpr std::array<int, 10> k_Ends{std::numeric_limits<int>::max(),
                                         std::numeric_limits<int>::min(),
                                         0,
                                         1,
                                         -1,
                                         16777216,
                                         16777217,
                                         16777219,
                                         -16777217,
                                         std::numeric_limits<int>::max() - 1};
    const int kind = random.Below(3);
    return kind == 0   ? k_Ends[static_cast<std::size_t>(random.Below(10))]
           : kind == 1 ? random.Below(2001) - 1000
                       : static_cast<int>(random.Below(std::numeric_limits<int>::max())) *
                             (random.Below(2) == 0 ? 1 : -1);
}

TEST(ParameterPrecision, AWholeNumberIsTheExactBlendRoundedTowardZero)
{
    RandomFloats random(6);
    IntParameter blended{nullptr, "x", 0};
    int meantCount = 0;
    for (int i = 0; i < k_CaseCount / 4; ++i)
    {
        const int from = AnyInt(random);
        const int to = AnyInt(random);
        const float share = random.Share();
        const float t = share < 0x1p-60f ? 0.0f : share;
        blended.Interp(from, to, t);
        const int value = blended.value();
        if (t == 0.0f)
        {
            ASSERT_EQ(from, value) << to;
            continue;
        }
        const WholeBlend exact(from, to, t);
        const bool isTruncated = Wide{value} == exact.Toward0();
        meantCount += isTruncated ? 0 : 1;
        ASSERT_TRUE(isTruncated || exact.Means(value))
            << from << " to " << to << " at " << t << " gives " << value;
        ASSERT_TRUE(value >= std::min(from, to) && value <= std::max(from, to));
        ASSERT_TRUE(t != 1.0f || value == to) << from << " to " << to << " gives " << value;
    }
    std::cout << "whole numbers that t means and just misses: " << meantCount << " of "
              << k_CaseCount / 4 << '\n';
}

TEST(ParameterPrecision, AWholeNumberBlendsToWhatTheDecimalSays)
{
    IntParameter blended{nullptr, "x", 0};
    for (int tenth = 0; tenth <= 10; ++tenth) // most tenths are a little less as a float
    {
        blended.Interp(0, 10, static_cast<float>(tenth) / 10.0f);
        EXPECT_EQ(tenth, blended.value());
        blended.Interp(10, -10, static_cast<float>(tenth) / 10.0f);
        EXPECT_EQ(10 - 2 * tenth, blended.value());
    }
}

} // namespace

} // namespace limn
