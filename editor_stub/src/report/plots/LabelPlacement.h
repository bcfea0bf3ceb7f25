#pragma once

#include <optional>
#include <span>
#include <vector>

namespace limn::study
{

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
