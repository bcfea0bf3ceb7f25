#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace limn::study
{

/// A logarithmic axis that all finite values from 1e-150 to 1e150 are on. Those of zero and below
/// have no place on one: they are drawn at its lower end, whose tick says so.
struct LogAxis
{
    double low = 0.1;
    double high = 1.0;
    bool clamps = false; ///< some values are drawn at `low`
    /// Where ticks are and what stands there.
    std::vector<std::pair<double, std::string>> ticks;

    double Clamped(double value) const; ///< NaN stays
    double Part(double value) const;    ///< of the axis: 0 at `low`, 1 at `high`
};

/// @param values  those that are not finite have no say
LogAxis MakeLogAxis(std::span<const double> values);
/// With ticks where they are given, of which there must be one above zero, and nowhere else.
LogAxis MakeLogAxis(std::vector<std::pair<double, std::string>> ticks);

/// Pixels; y goes down.
struct PixelBox
{
    double left;
    double top;
    double right;
    double bottom;
};

/// The area that two boxes share.
double Overlap(const PixelBox& a, const PixelBox& b);

/// A name that is to stand beside a point.
struct LabelWish
{
    double x;      ///< of the point
    double y;      ///< of the point
    double width;  ///< of the text
    double height; ///< of the text
    bool isNeeded; ///< placed even where it covers something
};

/// Where names stand so that they cover neither each other nor an obstacle: as near to their points
/// as there is room. Earlier ones choose first.
/// @param obstacles  points, lines
/// @param frame      that names stay in
/// @return for each wish its text's box; nothing if it found no room and is not needed
std::vector<std::optional<PixelBox>> PlaceLabels(std::span<const LabelWish> wishes,
                                                 std::span<const PixelBox> obstacles,
                                                 const PixelBox& frame);

} // namespace limn::study
