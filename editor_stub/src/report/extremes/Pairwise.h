#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace limn::study
{

/// A level of each factor, by its position.
using Combination = std::vector<int>;

/// Combinations in which every two levels of different factors meet at least once: what goes wrong
/// where two extremes meet shows in a few dozen tries instead of all tens of thousands. Always the
/// same for the same arguments. Where a factor's level does not matter it has its first one, so
/// make that the cheapest.
/// @param levelCounts  how many levels each factor has, at least two factors, at least one level
/// @source greedy one-test-at-a-time search: Cohen, Dalal, Fredman, Patton, "The AETG System", 1997
std::vector<Combination> CoverPairs(std::span<const int> levelCounts, std::uint32_t seed = 1);

/// Every combination that `isAllowed` lets through, the last factor changing fastest.
std::vector<Combination>
AllCombinations(std::span<const int> levelCounts,
                const std::function<bool(const Combination&)>& isAllowed = {});

} // namespace limn::study
