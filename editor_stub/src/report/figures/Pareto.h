#pragma once

#include "report/measure/Statistics.h"
#include "report/measure/Study.h"

#include <functional>
#include <limits>
#include <span>

namespace limn::study
{

/// What something costs and how far it is off; less of both is better.
struct TimeAndError
{
    double milliseconds;
    double error;
};

/// The points that no other point beats: none takes at most as long and is at most as far off, and
/// is better in one of them. Of equal points all are there; points with a NaN or an infinity never.
/// @return indices into the points, the quickest first; equal points in their order
std::vector<std::size_t> ParetoFront(std::span<const TimeAndError> points);

/// One technique in a comparison.
struct Standing
{
    const Technique* technique = nullptr; ///< in the study
    /// NaN where there is no such figure.
    TimeAndError at;
    std::pair<double, double> timeQuartiles;  ///< NaN if it has none
    std::pair<double, double> errorQuartiles; ///< NaN if it has none
    /// The time is within `at.milliseconds` ± this with 95 %; NaN where the run cannot tell.
    double timeUncertainty = std::numeric_limits<double>::quiet_NaN();
    /// The median over what moved; NaN where nothing did.
    Spread flicker = SpreadOf({});
    std::size_t failures = 0;       ///< stability cells that failed
    std::size_t stabilityCells = 0; ///< it was put through

    bool HasTime() const;     ///< which may not be known
    bool IsTimeKnown() const; ///< it has one, and 0 is not within its bound
    double ShortestTime() const { return at.milliseconds - timeUncertainty; }
    double LongestTime() const { return at.milliseconds + timeUncertainty; }
};

/// How the load of the machine went while times were measured.
struct LoadOfStudy
{
    std::size_t measurements = 0; ///< of several techniques each, in turn
    std::size_t changed = 0;      ///< those during which the load changed
    /// Where techniques are compared; of parts that were measured apart the least quiet. NaN
    /// without any.
    double quietPart = std::numeric_limits<double>::quiet_NaN();
    double quietMilliseconds = 0.0; ///< TimesInTurn::quietTime
    double busyMilliseconds = 0.0;  ///< TimesInTurn::busyTime
    /// OtherPrograms::BusyProcessors, the most where techniques are compared.
    double otherPrograms = 0.0;
};

/// All techniques of a study at one width: the mean error of the outline against the GPU time it
/// adds.
struct Comparison
{
    double width = 0.0; ///< pixels
    /// Of the pictures whose time is taken: the size of which most techniques have a time; of
    /// several the one that the scene's outline was compared at, else the largest.
    int pictureWidth = 0;
    int pictureHeight = 0;
    /// The median over the techniques' cells; NaN without any.
    double floorMilliseconds = 0.0;
    /// Whose error it is: "scene" where the scene's own outline was compared; else "" and the error
    /// is the median over all shapes, with their quartiles. At several sizes: the median over them.
    std::string subject;
    double flickerWidth = 0.0; ///< pixels, of what moved: the nearest to `width`; NaN without any
    LoadOfStudy load;
    std::vector<Standing> standings; ///< in the order of Study::techniques
    /// Into standings, the quickest first; of known times only.
    std::vector<std::size_t> front;
};

/// @param study  must outlive the result
/// @param width  pixels; 0 = that at which most techniques have both figures, of several the middle
///               one
Comparison Compare(const Study& study, double width = 0.0);

/// The width of the cells that `isOne` takes which is nearest to the wanted one; NaN if it takes
/// none.
double NearestWidth(const Study& study, double wanted,
                    const std::function<bool(const CellResult&)>& isOne);

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
