#include <cmath>
#include <gtest/gtest.h>
#include <limn/core/Mathf.h>

namespace limn
{
namespace
{

constexpr float k_NaN = std::numeric_limits<float>::quiet_NaN();

TEST(Mathf, RoundsHalvesToTheEvenNeighbour)
{
    // Unity's manual: Round of 10.5 is 10, of 11.5 is 12, of -10.5 is -10, of -11.5 is -12.
    EXPECT_EQ(10.0f, Mathf::Round(10.5f));
    EXPECT_EQ(12.0f, Mathf::Round(11.5f));
    EXPECT_EQ(-10.0f, Mathf::Round(-10.5f));
    EXPECT_EQ(-12.0f, Mathf::Round(-11.5f));
    EXPECT_EQ(10, Mathf::RoundToInt(10.2f));
    EXPECT_EQ(11, Mathf::RoundToInt(10.7f));
    EXPECT_EQ(1e30f, Mathf::Round(1e30f));
    // The largest float below one half: adding a half before would give 1.
    EXPECT_EQ(0.0f, Mathf::Round(0.49999997f));
}

TEST(Mathf, HasAnIntForEveryFloat)
{
    EXPECT_EQ(-3, Mathf::FloorToInt(-2.1f));
    EXPECT_EQ(-2, Mathf::CeilToInt(-2.1f));
    EXPECT_EQ(std::numeric_limits<int>::max(), Mathf::FloorToInt(Mathf::Infinity));
    EXPECT_EQ(std::numeric_limits<int>::min(), Mathf::CeilToInt(-1e20f));
    EXPECT_EQ(0, Mathf::RoundToInt(k_NaN));
    EXPECT_EQ(1073741824, Mathf::FloorToInt(1073741824.0f)); // 2^30: no digit is lost
}

TEST(Mathf, ClampsAndInterpolatesAsUnityDoes)
{
    EXPECT_EQ(10.0f, Mathf::Lerp(0.0f, 10.0f, 7.0f));
    EXPECT_EQ(-5.0f, Mathf::LerpUnclamped(0.0f, 10.0f, -0.5f));
    EXPECT_EQ(0.25f, Mathf::InverseLerp(4.0f, 8.0f, 5.0f));
    EXPECT_EQ(0.75f, Mathf::InverseLerp(8.0f, 4.0f, 5.0f));
    EXPECT_EQ(0.0f, Mathf::InverseLerp(3.0f, 3.0f, 9.0f));
    EXPECT_EQ(15.0f, Mathf::SmoothStep(10.0f, 20.0f, 0.5f));
    EXPECT_EQ(20.0f, Mathf::SmoothStep(10.0f, 20.0f, 4.0f));
    EXPECT_EQ(3, Mathf::Clamp(1, 3, 2)) << "the lower end is asked first";
    EXPECT_TRUE(std::isnan(Mathf::Clamp01(k_NaN)));
    EXPECT_EQ(1.0f, Mathf::Sign(0.0f));
    EXPECT_EQ(-1.0f, Mathf::Sign(-1e-40f));
}

TEST(Mathf, RepeatsAndReturns)
{
    EXPECT_EQ(0.5f, Mathf::Repeat(3.0f, 2.5f));
    EXPECT_EQ(2.0f, Mathf::Repeat(-0.5f, 2.5f));
    EXPECT_EQ(1.0f, Mathf::PingPong(3.0f, 2.0f));
    EXPECT_EQ(1.0f, Mathf::PingPong(-1.0f, 2.0f));
    EXPECT_EQ(7.0f, Mathf::MoveTowards(5.0f, 10.0f, 2.0f));
    EXPECT_EQ(10.0f, Mathf::MoveTowards(9.0f, 10.0f, 2.0f));
    EXPECT_EQ(3.0f, Mathf::MoveTowards(5.0f, 1.0f, 2.0f));
    // A negative step leads away, as in Unity.
    EXPECT_EQ(4.0f, Mathf::MoveTowards(5.0f, 10.0f, -1.0f));
}

TEST(Mathf, TellsFloatsThatAreNearlyEqual)
{
    EXPECT_TRUE(Mathf::Approximately(1.0f, 10.0f / 10.0f));
    EXPECT_TRUE(Mathf::Approximately(1e8f, 1e8f + 32.0f)); // 3.2e-7 of them
    EXPECT_FALSE(Mathf::Approximately(1.0f, 1.00001f));
    EXPECT_TRUE(Mathf::Approximately(0.0f, Mathf::Epsilon));
    EXPECT_FALSE(Mathf::Approximately(0.0f, 1e-10f));
    EXPECT_FALSE(Mathf::Approximately(k_NaN, k_NaN));
}

TEST(Mathf, KnowsPowersOfTwo)
{
    EXPECT_EQ(256, Mathf::NextPowerOfTwo(139));
    EXPECT_EQ(8, Mathf::NextPowerOfTwo(8));
    EXPECT_EQ(0, Mathf::NextPowerOfTwo(0));
    EXPECT_EQ(0, Mathf::NextPowerOfTwo(1073741825));
    EXPECT_TRUE(Mathf::IsPowerOfTwo(1073741824));
    EXPECT_FALSE(Mathf::IsPowerOfTwo(0));
    EXPECT_FALSE(Mathf::IsPowerOfTwo(12));
}

} // namespace
} // namespace limn
