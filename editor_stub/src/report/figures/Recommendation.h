#pragma once

#include "report/figures/Pareto.h"

namespace limn::study
{

/// Which technique to take.
struct Recommendation
{
    const Standing* standing = nullptr; ///< in the comparison; null if nothing fits
    std::string sentence;               ///< for people, with the figures
};

/// The least error within the budget: with a budget the longest that the time may be counts,
/// without one the time must be known. Of those whose error is the least to a hundredth and whose
/// times are not to be told apart the one that flickers least. The sentence names the others of
/// these, and what has less error but may not fit or has no known time.
/// @param comparison          must outlive the result
/// @param budgetMilliseconds  GPU time that may be added to a frame; may be infinite
Recommendation Recommend(const Comparison& comparison, double budgetMilliseconds);

/// What readers must know of the times, a sentence each: that the load of the machine changed, and
/// which times are not known.
std::vector<std::string> WarningsOf(const Comparison& comparison);

} // namespace limn::study
