#include "report/extremes/Pairwise.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <set>

namespace limn::study
{
namespace
{

/// Every two levels of different factors, looked for one by one.
void ExpectAllPairs(const std::vector<Combination>& rows, const std::vector<int>& counts)
{
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
        for (std::size_t k = i + 1; k < counts.size(); ++k)
        {
            std::set<std::pair<int, int>> seen;
            for (const Combination& row : rows)
            {
                ASSERT_EQ(row.size(), counts.size());
                seen.insert({row[i], row[k]});
            }
            std::set<std::pair<int, int>> all;
            for (int a = 0; a < counts[i]; ++a)
            {
                for (int b = 0; b < counts[k]; ++b)
                {
                    all.insert({a, b});
                }
            }
            EXPECT_EQ(seen, all) << "factors " << i << " and " << k;
        }
    }
}

const std::vector<int> k_SweepCounts = {8, 8, 4, 3, 7, 2, 2, 3};

TEST(CoverPairs, HasEveryPairOfLevels)
{
    for (const std::vector<int>& counts :
         {k_SweepCounts, {2, 2}, {1, 5}, {1, 1, 1}, {2, 3, 4, 5}, std::vector<int>(10, 2)})
    {
        for (const std::uint32_t seed : {1u, 99u})
        {
            ExpectAllPairs(CoverPairs(counts, seed), counts);
        }
    }
}

TEST(CoverPairs, TakesLittleMoreThanTheTwoLargestFactorsNeed)
{
    // No fewer than 8 x 8 can do; all of them are 64 512.
    EXPECT_LE(CoverPairs(k_SweepCounts).size(), 80u);
    EXPECT_EQ(AllCombinations(k_SweepCounts).size(), 64512u);
    EXPECT_LE(CoverPairs(std::vector<int>(10, 2)).size(), 10u) << "of 1024";
}

TEST(CoverPairs, IsTheSameEachTimeAndAnotherForAnotherSeed)
{
    EXPECT_EQ(CoverPairs(k_SweepCounts, 5), CoverPairs(k_SweepCounts, 5));
    EXPECT_NE(CoverPairs(k_SweepCounts, 5), CoverPairs(k_SweepCounts, 6));
}

TEST(CoverPairs, TakesTheFirstLevelWhereNoneIsNeeded)
{
    // The largest picture has to meet 8 widths and 8 ratios, and seldom more than that.
    const auto rows = CoverPairs(k_SweepCounts);
    EXPECT_LE(std::ranges::count_if(rows, [](const Combination& row) { return row[2] == 3; }), 12);
}

TEST(AllCombinations, AreThoseThatAreAllowed)
{
    const std::vector<int> counts = {2, 3};
    const std::vector<Combination> all = {{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}};
    EXPECT_EQ(AllCombinations(counts), all);
    const std::vector<Combination> some = {{0, 0}, {1, 0}, {1, 1}};
    EXPECT_EQ(AllCombinations(counts, [](const Combination& c) { return c[1] <= c[0]; }), some);
}

TEST(Combinations, OfNothingAreRefused)
{
    EXPECT_THROW(CoverPairs(std::vector<int>{3}), ContractError);
    EXPECT_THROW(CoverPairs(std::vector<int>{3, 0}), ContractError);
    EXPECT_THROW(AllCombinations(std::vector<int>{}), ContractError);
}

} // namespace
} // namespace limn::study
