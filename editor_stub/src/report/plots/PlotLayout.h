#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace limn::study
{

/// A logarithmic axis for all finite values from 1e-150 to 1e150. Values of zero and below have no
/// place on it: they are drawn at its lower end, whose tick marks that.
struct LogAxis
{
    double low = 0.1;
    double high = 1.0;
    bool clamps = false; ///< true if some values are drawn at `low`
    /// The values of ticks and their texts.
    std::vector<std::pair<double, std::string>> ticks;

    double Clamped(double value) const; ///< the value as it is drawn; NaN stays NaN
    double Part(double value) const;    ///< the value's place on the axis: 0 at `low`, 1 at `high`
};

/// Returns an axis that fits the values.
/// @param values  values that are not finite are ignored
LogAxis MakeLogAxis(std::span<const double> values);
/// Returns an axis with the given ticks and no others. At least one must be above zero.
LogAxis MakeLogAxis(std::vector<std::pair<double, std::string>> ticks);

/// A box in pixels; y goes down.
struct PixelBox
{
    double left;
    double top;
    double right;
    double bottom;
};

/// Returns the area that two boxes share.
double Overlap(const PixelBox& a, const PixelBox& b);

/// A name that is to stand beside a point.
struct LabelWish
{
    double x;      ///< of the point
    double y;      ///< of the point
    double width;  ///< of the text
    double height; ///< of the text
    bool isNeeded; ///< true if it is placed even where it covers something
};

/// Places names so that they cover neither each other nor an obstacle, as near to their points as
/// there is room. Earlier names choose first.
/// @param obstacles  the boxes of points and lines
/// @param frame      the box that names stay in
/// @return the box of each wish's text; nothing for a text that found no room and is not needed
std::vector<std::optional<PixelBox>> PlaceLabels(std::span<const LabelWish> wishes,
                                                 std::span<const PixelBox> obstacles,
                                                 const PixelBox& frame);

} // namespace limn::study
