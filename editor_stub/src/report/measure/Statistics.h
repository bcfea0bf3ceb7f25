#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace limn::study
{

/// The lower quartile, the median and the upper quartile of the finite values, interpolated
/// linearly between neighbours. NaN if there are no values.
struct Spread
{
    double lower;
    double median;
    double upper;
};
Spread SpreadOf(std::vector<double> values);

// The time that a technique adds to a frame is found as follows, whatever else the machine does
// meanwhile:
//
// 1. Each frame with an outline is drawn between two frames without one; the three are a pair. The
//    pair's difference is the time of the first minus the mean of the other two.
// 2. A pair counts if it was drawn at a quiet moment: the eight frames without an outline around it
//    (TimesInTurn::k_Around on each side, without its own two, so that they are not chosen by
//    their own noise) have a median near the run's quiet time, and each of its own two frames is
//    near that time as well. "Near" is 25 %, or four times the scatter of such frames if that is
//    more.
// 3. The figure is the median of the differences that count. Its bound is that of the sign test:
//    two of the sorted differences, whatever their distribution. See BoundOfMedian for what widens
//    it.
// 4. If frames that count were slower than their quietest tenth (of medians of three without an
//    outline), the lower end falls by as much, since the difference grew with them. Frames are not
//    scaled by the load otherwise, since a load does not slow down all passes alike.
//
// The load of the machine changed if more than a tenth of the frames without an outline were not
// near the quiet time, or if those around them were not.

/// An interval that holds a median with 95 %. NaN if there are too few values.
struct Bound
{
    double low;
    double high;
};

/// Returns the bound of the median of the distribution that the values come from, by the sign test.
/// Values that resemble their neighbours count as fewer values. How many fewer follows from the
/// variance of the signs' sums over blocks of 2, 4, 8, ... neighbours, with the block length that
/// makes it largest.
/// @param inOrder    the values in the order they were measured
/// @param disturbed  the part of the values, 0 to 1, that something else may have raised; the lower
///     end is lower by as many ranks
Bound BoundOfMedian(std::span<const double> inOrder, double disturbed = 0.0);

/// The time that a technique adds to a frame.
struct TimeAdded
{
    /// The frame with the outline, in the pairs that count, or in all pairs if none counts.
    Spread frame;
    Spread added; ///< the differences of these pairs
    /// The time added at the run's quietest moments is within `added.median` ± this with 95 %. NaN
    /// if too few pairs count to tell.
    double uncertainty;
};

/// Returns the order in which frames are drawn: 0 for the frame without an outline, which is drawn
/// before and after each technique, and 1...`techniques` for the techniques. Each technique draws
/// once a round, in another order each round. The result is the same in every run.
std::vector<std::size_t> TurnsOf(std::size_t techniques, int rounds);

/// The times of frames that were drawn in turn.
class TimesInTurn
{
public:
    static constexpr std::size_t k_Around = 4;

    /// @param turns         as TurnsOf returns them; must outlive this
    /// @param milliseconds  the time of each turn's frame; must outlive this
    TimesInTurn(std::span<const std::size_t> turns, std::span<const double> milliseconds);

    TimeAdded AddedBy(std::size_t technique) const;

    /// Returns the quiet time of the frame without an outline.
    double quietTime() const { return m_QuietTime; }
    double busyTime() const { return m_BusyTime; } ///< 19 of 20 of these frames were quicker
    /// Returns the part of these frames that was near the quiet time.
    double quietPart() const { return m_QuietPart; }

private:
    std::size_t PairCount() const { return m_Turns.size() / 2; }
    double Outlined(std::size_t pair) const { return m_Milliseconds[2 * pair + 1]; }
    double Before(std::size_t pair) const { return m_Milliseconds[2 * pair]; }
    double Behind(std::size_t pair) const { return m_Milliseconds[2 * pair + 2]; }
    double TimeAround(std::size_t pair) const;
    double MedianOfThree(std::size_t pair) const;
    void FindQuietTime();
    void ChoosePairs();

    std::span<const std::size_t> m_Turns;
    std::span<const double> m_Milliseconds;
    std::vector<double> m_Around; ///< by pair: the median of the frames without an outline
    std::vector<bool> m_IsQuiet;  ///< by pair: the frames around it are near the quiet time
    std::vector<bool> m_Counts;   ///< by pair
    double m_Near = 0.0;          ///< relative to the quiet time
    double m_QuietTime = 0.0;
    double m_BusyTime = 0.0;
    double m_LeastQuietTime = 0.0; ///< the quiet time in the quietest tenth of the quiet frames
    double m_QuietPart = 0.0;
    double m_Disturbed = 0.0; ///< the part of the frames without an outline that were far off
};

/// Returns whether the load of the machine changed during a run.
/// @param quietPart  TimesInTurn::quietPart
bool HasLoadChanged(double quietPart);

} // namespace limn::study
