#include "renderers/SortEntries.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace limn
{
namespace
{

TEST(RadixSorting, PutsEntriesIntoTheOrderThatComparingThemGives)
{
    std::mt19937_64 random(7);
    for (const auto& [bits, count] : {std::pair(0, 1000),
                                      {1, 1000},
                                      {5, 1000},
                                      {12, 1000},
                                      {32, 1000},
                                      {47, 1000},
                                      {64, 1000},
                                      {0, 20},
                                      {1, 20},
                                      {2, 64},
                                      {64, 64},
                                      {64, 65},
                                      {64, 1},
                                      {64, 0}})
    {
        std::vector<SortEntry> entries(static_cast<std::size_t>(count));
        for (std::uint32_t i = 0; i < entries.size(); ++i)
        {
            entries[i] = {bits == 0 ? 5 : random() >> (64 - bits) << (random() % 2),
                          static_cast<std::uint32_t>(random()) & 0xF00FF0F0u, i};
        }
        std::vector<SortEntry> expected = entries;
        std::ranges::stable_sort(expected, {},
                                 [](const SortEntry& e) { return std::pair(e.key, e.state); });
        std::vector<SortEntry> spare;
        RadixSort(entries, spare);
        EXPECT_TRUE(std::ranges::equal(expected, entries, {}, &SortEntry::index, &SortEntry::index))
            << count << " of " << bits << " bits";
    }
}

TEST(RadixSorting, LeavesWordsInTheirOrderThatDifferBelowTheFirstBitOnly)
{
    std::mt19937_64 random(8);
    for (const std::size_t count : {0u, 1u, 20u, 64u, 65u, 1000u})
    {
        for (const int firstBit : {0, 7, 40, 63, 64})
        {
            std::vector<std::uint64_t> words(count);
            std::ranges::generate(words, [&] { return random() & random() & random(); });
            std::vector<std::uint64_t> expected = words;
            std::ranges::stable_sort(expected, {},
                                     [firstBit](std::uint64_t word)
                                     { return firstBit < 64 ? word >> firstBit : 0; });
            std::vector<std::uint64_t> spare;
            RadixSort(words, spare, firstBit);
            EXPECT_EQ(expected, words) << count << " words from bit " << firstBit;
        }
    }
}

TEST(Quantising, TakesTheEighthOfTheOctaveOfADistance)
{
    for (double distance = 2e-3; distance < 1e18; distance *= 1.0137)
    {
        const double eighth = 8.0 * std::log2(distance);
        if (std::abs(eighth - std::round(eighth)) > 1e-5) // between two a float may be on either
        {
            const double square = distance * distance;
            // 127 is what a float's exponent has added.
            EXPECT_EQ(
                Quantised(static_cast<float>(square)),
                static_cast<std::uint32_t>(1 + 4 * 127 + static_cast<int>(std::floor(eighth))))
                << distance;
        }
    }
    EXPECT_EQ(Quantised(1e-7f), 0u);
    EXPECT_EQ(Quantised(-5.0f), 0u);
}

} // namespace
} // namespace limn
