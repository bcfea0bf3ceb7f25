#include "report/figures/Pareto.h"

#include "console/Texts.h"
#include "report/figures/Numbers.h"

#include <algorithm>
#include <cmath>

namespace limn::study
{

namespace
{

/// "1.2 ± 0.3 ms", "0.2 ± 0.5 ms, so at most 0.7 ms".
std::string TimeOf(const Standing& standing)
{
    const std::string time = Readable(standing.at.milliseconds);
    if (std::isnan(standing.timeUncertainty))
    {
        return time + " ms";
    }
    const std::string bounded = time + " ± " + Readable(standing.timeUncertainty) + " ms";
    return standing.IsTimeKnown()
               ? bounded
               : bounded + ", so at most " + Readable(standing.LongestTime()) + " ms";
}

std::string Figures(const Standing& standing)
{
    return "mean error " + Readable(standing.at.error) +
           (std::isnan(standing.flicker.median)
                ? ""
                : " and flicker " + Readable(standing.flicker.median)) +
           " for " + TimeOf(standing);
}

std::string Place(const Comparison& comparison)
{
    return Readable(comparison.width) + " px wide, in a picture of " +
           SizeText(comparison.pictureWidth, comparison.pictureHeight) +
           (std::isnan(comparison.flickerWidth)
                ? ""
                : "; flicker of shapes, " + Readable(comparison.flickerWidth) + " px wide");
}

/// The time is within the budget however long it is, or known where there is no budget.
bool Fits(const Standing& standing, double budget)
{
    return std::isinf(budget) ? standing.IsTimeKnown()
                              : standing.LongestTime() > 0.0 && standing.LongestTime() <= budget;
}

/// The time may be within the budget or beyond it.
bool MayFit(const Standing& standing, double budget)
{
    return standing.ShortestTime() <= budget && standing.LongestTime() > budget;
}

/// There is a time, but not even how long it is at most.
bool IsUnknown(const Standing& standing, double budget)
{
    return standing.HasTime() && !Fits(standing, budget) && !MayFit(standing, budget) &&
           !(standing.ShortestTime() > budget);
}

/// A standing with less error than the chosen one; every standing with an error if none is chosen.
bool IsNearer(const Standing& standing, const Standing* chosen)
{
    return std::isfinite(standing.at.error) &&
           (chosen == nullptr || standing.at.error < chosen->at.error);
}

/// The least error that fits; of equal errors the quickest. Null if nothing fits.
const Standing* LeastError(const Comparison& comparison, double budget)
{
    const Standing* least = nullptr;
    for (const Standing& standing : comparison.standings)
    {
        const bool isQuicker = least != nullptr && standing.at.error == least->at.error &&
                               standing.at.milliseconds < least->at.milliseconds;
        if (Fits(standing, budget) && (IsNearer(standing, least) || isQuicker))
        {
            least = &standing;
        }
    }
    return least;
}

/// Returns whether a standing has the least error to a hundredth, and its time may be as short, as
/// far as both times are known.
bool IsAsGood(const Standing& standing, const Standing& least, double budget)
{
    return Fits(standing, budget) && standing.at.error <= least.at.error * 1.01 &&
           standing.ShortestTime() <= least.LongestTime();
}

/// Names joined by commas, those with their figures that are wanted.
std::string NamesOf(const Comparison& comparison, const auto& isWanted, const auto& figures)
{
    std::string names;
    for (const Standing& standing : comparison.standings)
    {
        if (isWanted(standing))
        {
            const std::string those = figures(standing);
            names += (names.empty() ? "" : ", ") + standing.technique->name +
                     (those.empty() ? "" : " (" + those + ")");
        }
    }
    return names;
}

/// Returns a sentence about techniques that have less error and may be better; the measurements do
/// not decide it.
std::string CannotTell(const Comparison& comparison, const Standing* chosen, double budget)
{
    const std::string undecided = NamesOf(
        comparison,
        [&](const Standing& standing)
        { return IsNearer(standing, chosen) && MayFit(standing, budget); },
        Figures);
    const std::string unknown = NamesOf(
        comparison,
        [&](const Standing& standing)
        { return IsNearer(standing, chosen) && IsUnknown(standing, budget); },
        [](const Standing& standing) { return "mean error " + Readable(standing.at.error); });
    return (undecided.empty() ? ""
                              : " This run cannot tell whether these fit: " + undecided + ".") +
           (unknown.empty() ? "" : " This run does not know the time of " + unknown + ".");
}

/// "Within 2 ms take ".
std::string Opening(const Comparison& comparison, const Standing& chosen, double budget)
{
    if (!std::isinf(budget))
    {
        return "Within " + Readable(budget) + " ms take ";
    }
    const bool isLeast = std::ranges::none_of(
        comparison.standings, [&](const Standing& standing)
        { return IsNearer(standing, &chosen) && IsUnknown(standing, budget); });
    return isLeast ? "With all the time there is take "
                   : "Of those whose time this run knows take ";
}

/// Returns a sentence about the technique that would be better with more time.
std::string MoreTimeBuys(const Comparison& comparison, const Standing& chosen, double budget)
{
    for (const std::size_t index : comparison.front)
    {
        const Standing& other = comparison.standings[index];
        if (IsNearer(other, &chosen) && other.ShortestTime() > budget)
        {
            return " More time buys less error: " + other.technique->name + " has " +
                   Figures(other) + ".";
        }
    }
    return "";
}

/// Returns the technique with the least flicker among those that are as good as the least error.
const Standing& LeastFlicker(const Comparison& comparison, const Standing& least, double budget)
{
    const Standing* chosen = &least;
    for (const Standing& standing : comparison.standings)
    {
        if (IsAsGood(standing, least, budget) && standing.flicker.median < chosen->flicker.median)
        {
            chosen = &standing;
        }
    }
    return *chosen;
}

/// Returns a sentence about the others that are as good as the chosen one.
std::string AsGood(const Comparison& comparison, const Standing& chosen, const Standing& least,
                   double budget)
{
    const std::string others = NamesOf(
        comparison,
        [&](const Standing& standing)
        { return &standing != &chosen && IsAsGood(standing, least, budget); },
        [](const Standing& standing)
        {
            const double flicker = standing.flicker.median;
            return std::isnan(flicker) ? std::string() : "flicker " + Readable(flicker);
        });
    return others.empty() ? "" : " As good, as far as the times tell: " + others + ".";
}

/// Why there is nothing to recommend.
std::string NothingFits(const Comparison& comparison, double budget)
{
    const auto hasBoth = [](const Standing& standing)
    {
        return standing.HasTime() && std::isfinite(standing.at.error);
    };
    if (std::ranges::none_of(comparison.standings, hasBoth))
    {
        return "No technique has both an error and a time to choose by.";
    }
    if (comparison.front.empty())
    {
        return "There is no recommendation: this run does not know the time of any technique. "
               "Measure again on a quieter machine.";
    }
    const Standing& quickest = comparison.standings[comparison.front.front()];
    return "Nothing fits " + Readable(budget) + " ms for certain: the quickest outline is " +
           quickest.technique->name + " with " + Figures(quickest) + " (" + Place(comparison) +
           ").";
}

} // namespace

Recommendation Recommend(const Comparison& comparison, double budgetMilliseconds)
{
    Recommendation result;
    const Standing* const least = LeastError(comparison, budgetMilliseconds);
    if (least == nullptr)
    {
        result.sentence = NothingFits(comparison, budgetMilliseconds);
        result.more =
            comparison.front.empty() ? "" : CannotTell(comparison, nullptr, budgetMilliseconds);
        result.more.erase(0, 1); // the space before the first sentence
        return result;
    }
    const Standing& chosen = LeastFlicker(comparison, *least, budgetMilliseconds);
    result.standing = &chosen;
    result.sentence = Opening(comparison, chosen, budgetMilliseconds) + chosen.technique->name +
                      ": " + Figures(chosen) + " (" + Place(comparison) + ").";
    if (chosen.failures > 0)
    {
        result.more = " It failed " + std::to_string(chosen.failures) + " of " +
                      CountText(chosen.stabilityCells, "stability check") + ".";
    }
    result.more += AsGood(comparison, chosen, *least, budgetMilliseconds) +
                   CannotTell(comparison, &chosen, budgetMilliseconds) +
                   MoreTimeBuys(comparison, chosen, budgetMilliseconds);
    result.more.erase(0, 1); // the space before the first sentence
    return result;
}

std::vector<std::string> WarningsOf(const Comparison& comparison)
{
    std::vector<std::string> warnings;
    const LoadOfStudy& load = comparison.load;
    if (HasLoadChanged(load.quietPart))
    {
        warnings.push_back("The load changed during this run: the frame without an outline took " +
                           Readable(load.quietMilliseconds) + " ms in " +
                           Readable(std::round(load.quietPart * 100.0)) + " % of it and up to " +
                           Readable(load.busyMilliseconds) +
                           " ms in the rest, which counts for nothing.");
    }
    else if (load.changed > 0)
    {
        warnings.push_back("The load changed during " + std::to_string(load.changed) + " of " +
                           CountText(load.measurements, "measurement") +
                           " of time; not where techniques are compared.");
    }
    constexpr double k_ManyProcessors = 0.2;
    if (load.otherPrograms > k_ManyProcessors)
    {
        warnings.push_back("Other programs kept busy " + Readable(load.otherPrograms) +
                           " of the machine's processors during this run: all of its times may be "
                           "too long, which their ± does not hold.");
    }
    const std::string unknown = NamesOf(
        comparison,
        [](const Standing& standing) { return standing.HasTime() && !standing.IsTimeKnown(); },
        TimeOf);
    if (!unknown.empty())
    {
        warnings.push_back("This run does not know these times, of which 0 is within the bound or "
                           "for which too little of it was quiet: " +
                           unknown +
                           ". Measure again on a quieter machine before choosing by them.");
    }
    return warnings;
}

} // namespace limn::study
