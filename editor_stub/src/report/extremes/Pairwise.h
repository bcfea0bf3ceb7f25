#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace limn::study
{

/// One level for each factor, as an index.
using Combination = std::vector<int>;

/// Returns combinations in which every two levels of different factors meet at least once. An error
/// that occurs where two extremes meet then shows in a few dozen tries instead of tens of
/// thousands. The result is always the same for the same arguments. A factor whose level does not
/// matter has its first level, so make that the cheapest.
/// @param levelCounts  the number of levels of each factor; at least two factors, at least one
///     level
/// @source greedy one-test-at-a-time search: Cohen, Dalal, Fredman, Patton, "The AETG System", 1997
std::vector<Combination> CoverPairs(std::span<const int> levelCounts, std::uint32_t seed = 1);

/// Returns every combination that `isAllowed` accepts. The last factor changes fastest.
std::vector<Combination>
AllCombinations(std::span<const int> levelCounts,
                const std::function<bool(const Combination&)>& isAllowed = {});

} // namespace limn::study
