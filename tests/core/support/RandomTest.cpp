#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limn/core/Random.h>
#include <set>
#include <vector>

namespace limn
{
namespace
{

TEST(RandomNumbers, BeginAnewWithTheirSeed)
{
    const auto numbersOf = [](int seed)
    {
        Random::InitState(seed);
        return std::vector{Random::value(), Random::Range(-1.0f, 1.0f)};
    };
    const std::vector<float> first = numbersOf(7);
    EXPECT_NE(numbersOf(8), first);
    EXPECT_EQ(numbersOf(7), first);
}

TEST(RandomNumbers, FillTheirRangeEvenly)
{
    Random::InitState(1);
    constexpr int k_Count = 40000;
    std::array<int, 4> quarters{};
    for (int i = 0; i < k_Count; ++i)
    {
        const float number = Random::Range(3.0f, -1.0f);
        ASSERT_GE(number, -1.0f);
        ASSERT_LE(number, 3.0f);
        ++quarters.at(std::min(static_cast<std::size_t>(number + 1.0f), std::size_t{3}));
    }
    const double deviation = std::sqrt(k_Count * 0.25 * 0.75); // of a binomial distribution
    for (const int count : quarters)
    {
        EXPECT_NEAR(count, k_Count / 4, 5 * deviation);
    }
}

TEST(RandomNumbers, AreWholeOnesBelowTheSecondLimit)
{
    Random::InitState(2);
    std::set<int> up;
    std::set<int> down;
    for (int i = 0; i < 1000; ++i)
    {
        up.insert(Random::Range(-1, 2));
        down.insert(Random::Range(2, -1));
    }
    EXPECT_EQ(up, (std::set{-1, 0, 1}));
    EXPECT_EQ(down, (std::set{0, 1, 2}));
    EXPECT_EQ(Random::Range(5, 5), 5);
}

} // namespace
} // namespace limn
