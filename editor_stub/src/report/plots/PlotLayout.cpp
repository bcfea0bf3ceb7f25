#include "report/plots/PlotLayout.h"

#include "report/figures/Numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace limn::study
{

namespace
{

// Farther ones are drawn at the ends: what the ends are computed from stays finite.
constexpr double k_Least = 1e-150;
constexpr double k_Most = 1e150;

/// Powers of ten; with 2 and 5 between them where that is not too much.
std::vector<std::pair<double, std::string>> DecimalTicks(double low, double high)
{
    const double decades = std::log10(high / low);
    const int step = decades > 8.0 ? 2 : 1;
    std::vector<std::pair<double, std::string>> ticks;
    for (int power = static_cast<int>(std::floor(std::log10(low)));
         power <= static_cast<int>(std::ceil(std::log10(high))); power += step)
    {
        for (const double digit : {1.0, 2.0, 5.0})
        {
            const double value = digit * std::pow(10.0, power);
            if (value >= low && value <= high && (digit == 1.0 || decades <= 2.5))
            {
                ticks.emplace_back(value, Readable(value));
            }
        }
    }
    return ticks;
}

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
    return std::accumulate(obstacles.begin(), obstacles.end(), 0.0,
                           [&box](double area, const PixelBox& obstacle)
                           { return area + Overlap(box, obstacle); });
}

} // namespace

double LogAxis::Clamped(double value) const
{
    return std::isnan(value) ? value : std::clamp(value, low, high);
}

double LogAxis::Part(double value) const
{
    return std::log(Clamped(value) / low) / std::log(high / low);
}

LogAxis MakeLogAxis(std::span<const double> values)
{
    LogAxis axis;
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const double value : values)
    {
        axis.clamps |= std::isfinite(value) && value <= 0.0;
        if (std::isfinite(value) && value > 0.0)
        {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    }
    if (most == 0.0)
    {
        least = most = 1.0;
    }
    least = std::max(least, k_Least);
    most = std::clamp(most, k_Least, k_Most);
    const double margin = std::max(std::pow(most / least, 0.06), 1.3);
    axis.low = least / margin;
    axis.high = most * margin;
    if (axis.clamps)
    {
        axis.low = least / std::pow(axis.high / least, 0.12) / margin;
    }
    // No tick so near to the lower end that its text would cover the one there.
    const double first = axis.clamps ? axis.low * std::pow(axis.high / axis.low, 0.06) : axis.low;
    axis.ticks = DecimalTicks(first, axis.high);
    if (axis.clamps)
    {
        axis.ticks.emplace_back(axis.low, "≤ 0");
    }
    return axis;
}

LogAxis MakeLogAxis(std::vector<std::pair<double, std::string>> ticks)
{
    std::vector<double> values;
    std::ranges::transform(ticks, std::back_inserter(values),
                           [](const auto& tick) { return tick.first; });
    LogAxis axis = MakeLogAxis(values);
    axis.ticks = std::move(ticks);
    return axis;
}

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
    constexpr std::array<std::array<double, 2>, 8> k_LabelSides = {
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
            for (const auto& [alongX, alongY] : k_LabelSides)
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
