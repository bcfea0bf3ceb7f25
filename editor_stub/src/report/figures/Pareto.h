#pragma once

#include "report/measure/Statistics.h"
#include "report/measure/Study.h"

#include <cmath>
#include <functional>
#include <limits>
#include <span>

namespace limn::study
{

/// The cost of something and its error. Less of both is better.
struct TimeAndError
{
    double milliseconds;
    double error;

    auto operator<=>(const TimeAndError&) const = default;
};

/// Returns the points that no other point beats. A point beats another if it is at most as slow and
/// at most as far off, and better in one of the two. All of several equal points are in the result;
/// points with a NaN or an infinity never are.
/// @return the indices of the points, the quickest first; equal points in their order
std::vector<std::size_t> ParetoFront(std::span<const TimeAndError> points);

/// One technique in a comparison.
struct Standing
{
    static constexpr double k_None = std::numeric_limits<double>::quiet_NaN();
    const Technique* technique = nullptr; ///< in the study
    /// The technique's time and error. NaN where there is no such figure.
    TimeAndError at{k_None, k_None};
    std::pair<double, double> timeQuartiles{k_None, k_None};  ///< NaN if it has none
    std::pair<double, double> errorQuartiles{k_None, k_None}; ///< NaN if it has none
    /// The time is within `at.milliseconds` ± this with 95 %. NaN if the run cannot tell.
    double timeUncertainty = k_None;
    /// The median is over all that moved. NaN if nothing moved.
    Spread flicker = SpreadOf({});
    std::size_t failures = 0;       ///< stability cells that failed
    std::size_t stabilityCells = 0; ///< the stability cells that it was tested with

    /// Returns whether it has a time, whose bound may include 0.
    bool HasTime() const { return std::isfinite(at.milliseconds); }
    /// Returns whether it has a time and 0 is not within its bound.
    bool IsTimeKnown() const { return ShortestTime() > 0.0 && std::isfinite(LongestTime()); }
    double ShortestTime() const { return at.milliseconds - timeUncertainty; }
    double LongestTime() const { return at.milliseconds + timeUncertainty; }
};

/// The load of the machine while times were measured.
struct LoadOfStudy
{
    /// The number of measurements, each of several techniques in turn.
    std::size_t measurements = 0;
    std::size_t changed = 0; ///< the number of measurements during which the load changed
    /// The quiet part of the measurements by which techniques are compared; the least quiet one of
    /// parts that were measured separately. NaN if there is none.
    double quietPart = std::numeric_limits<double>::quiet_NaN();
    double quietMilliseconds = 0.0; ///< TimesInTurn::quietTime
    double busyMilliseconds = 0.0;  ///< TimesInTurn::busyTime
    /// OtherPrograms::BusyProcessors, the most of the measurements by which techniques are
    /// compared.
    double otherPrograms = 0.0;
};

/// All techniques of a study at one width: the mean error of the outline against the GPU time it
/// adds.
struct Comparison
{
    double width = 0.0; ///< in pixels
    /// The size of the pictures whose time is taken. It is the size at which most techniques have a
    /// time; among several such sizes the one at which the scene's outline was compared, else the
    /// largest.
    int pictureWidth = 0;
    int pictureHeight = 0;
    /// The median over the techniques' cells; NaN if there are none.
    double floorMilliseconds = 0.0;
    /// The subject whose error it is: "scene" if the scene's own outline was compared; else "", and
    /// the error is the median over all shapes, with their quartiles. If there are several sizes,
    /// it is the median over them.
    std::string subject;
    /// The width at which something moved that is nearest to `width`, in pixels; NaN if nothing
    /// moved.
    double flickerWidth = 0.0;
    LoadOfStudy load;
    std::vector<Standing> standings; ///< in the order of Study::techniques
    /// Indices into standings, the quickest first. Only known times are in it.
    std::vector<std::size_t> front;
};

/// @param study  must outlive the result
/// @param width  in pixels; 0 = the width at which most techniques have both figures, the middle
///     one of several
Comparison Compare(const Study& study, double width = 0.0);

/// Returns the width, among the cells that `isOne` accepts, that is nearest to the wanted one, or
/// NaN if it accepts none.
double NearestWidth(const Study& study, double wanted,
                    const std::function<bool(const CellResult&)>& isOne);

/// The technique to take, and why.
struct Recommendation
{
    const Standing* standing = nullptr; ///< an element of the comparison; null if nothing fits
    std::string sentence;               ///< a sentence for people, with the figures
    std::string more;                   ///< further sentences: failed checks, others; may be ""

    std::string Text() const { return sentence + (more.empty() ? "" : " " + more); }
};

/// Recommends the technique with the least error within the budget. With a budget, the upper bound
/// of the time counts; without one, the time must be known. Among techniques whose error is the
/// least to a hundredth and whose times cannot be told apart, it recommends the one that flickers
/// least. The further sentences name the others of these, and techniques that have less error but
/// may not fit or have no known time.
/// @param comparison          must outlive the result
/// @param budgetMilliseconds  the GPU time that may be added to a frame; may be infinite
Recommendation Recommend(const Comparison& comparison, double budgetMilliseconds);

/// Returns what readers must know about the times, a sentence each: that the load of the machine
/// changed, and which times are not known.
std::vector<std::string> WarningsOf(const Comparison& comparison);

} // namespace limn::study
