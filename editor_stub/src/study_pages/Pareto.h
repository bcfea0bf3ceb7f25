#pragma once

#include "study/Study.h"

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
    const TechniqueInfo* technique = nullptr; ///< in the study
    /// NaN where there is no such figure.
    TimeAndError at;
    std::pair<double, double> timeQuartiles;  ///< NaN if it has none
    std::pair<double, double> errorQuartiles; ///< NaN if it has none
    /// Half the interval in which the median of the time lies with 95 %, milliseconds; 0 if
    /// unknown.
    double timeUncertainty = 0.0;
    std::size_t failures = 0;       ///< stability cells that failed
    std::size_t stabilityCells = 0; ///< it was put through
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
    std::vector<Standing> standings; ///< in the order of Study::techniques
    std::vector<std::size_t> front;  ///< into standings, the quickest first
};

/// @param study  must outlive the result
/// @param width  pixels; 0 = that at which most techniques have both figures, of several the middle
///               one
Comparison Compare(const Study& study, double width = 0.0);

/// Which technique to take.
struct Recommendation
{
    const Standing* standing = nullptr; ///< in the comparison; null if nothing fits
    std::string sentence;               ///< for people, with the figures
};

/// The least error whose time is within the budget; of equal errors the quickest, and what is as
/// good and by its time not to be told from it is named.
/// @param comparison          must outlive the result
/// @param budgetMilliseconds  GPU time that may be added to a frame; may be infinite
Recommendation Recommend(const Comparison& comparison, double budgetMilliseconds);

} // namespace limn::study
