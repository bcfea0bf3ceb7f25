#include "report/plots/LabelPlacement.h"

#include <algorithm>
#include <array>
#include <limits>

namespace limn::study
{

namespace
{

/// The text's box at a distance from the point. The direction is -1, 0 or 1 along each axis.
PixelBox BoxAt(const LabelWish& wish, double alongX, double alongY, double distance)
{
    const double x = wish.x + alongX * (distance + wish.width / 2.0);
    const double y = wish.y + alongY * (distance + wish.height / 2.0);
    return {x - wish.width / 2.0, y - wish.height / 2.0, x + wish.width / 2.0,
            y + wish.height / 2.0};
}

bool IsInside(const PixelBox& box, const PixelBox& frame)
{
    return box.left >= frame.left && box.right <= frame.right && box.top >= frame.top &&
           box.bottom <= frame.bottom;
}

double Covered(const PixelBox& box, std::span<const PixelBox> obstacles)
{
    double area = 0.0;
    for (const PixelBox& obstacle : obstacles)
    {
        area += Overlap(box, obstacle);
    }
    return area;
}

} // namespace

double Overlap(const PixelBox& a, const PixelBox& b)
{
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return width > 0.0 && height > 0.0 ? width * height : 0.0;
}

std::vector<std::optional<PixelBox>> PlaceLabels(std::span<const LabelWish> wishes,
                                                 std::span<const PixelBox> obstacles,
                                                 const PixelBox& frame)
{
    // The best known first: right, left, then the corners, above and below.
    constexpr std::array<std::array<double, 2>, 8> k_Directions = {
        {{1, 0}, {-1, 0}, {1, -1}, {1, 1}, {-1, -1}, {-1, 1}, {0, -1}, {0, 1}}};
    constexpr std::array k_Distances = {9.0, 16.0, 26.0, 40.0, 58.0, 80.0};
    std::vector<PixelBox> taken(obstacles.begin(), obstacles.end());
    std::vector<std::optional<PixelBox>> result;
    for (const LabelWish& wish : wishes)
    {
        std::optional<PixelBox> best;
        double least = std::numeric_limits<double>::infinity();
        for (const double distance : k_Distances)
        {
            for (const auto& [alongX, alongY] : k_Directions)
            {
                const PixelBox box = BoxAt(wish, alongX, alongY, distance);
                const double covered = Covered(box, taken);
                if (IsInside(box, frame) && covered < least)
                {
                    best = box;
                    least = covered;
                }
            }
        }
        if (!wish.isNeeded && least > 0.0)
        {
            best.reset();
        }
        if (best)
        {
            taken.push_back(*best);
        }
        result.push_back(best);
    }
    return result;
}

} // namespace limn::study
