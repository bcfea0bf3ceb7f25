#include "report/extremes/Stability.h"

#include <algorithm>
#include <cmath>

namespace limn::study
{

namespace
{

/// The READMEs' shapes are no smaller. In smaller ones corners count, where a border pixel may be
/// off by so much; the sharp tips of a star are off by more (stroke_outline/README.md).
constexpr double k_SmallestShape = 20.0; // pixels
constexpr double k_CornerError = 0.4;
/// What is thinner falls between four samples (wide_outline/README.md).
constexpr double k_Hair = 0.3; // pixels

struct BoundFigure
{
    double width;
    double error;
};

/// Between the figures of a table, straight over the logarithm of the width.
double BoundBetween(std::span<const BoundFigure> figures, double width)
{
    if (width <= figures.front().width)
    {
        return figures.front().error;
    }
    for (std::size_t i = 1; i < figures.size(); ++i)
    {
        const BoundFigure& low = figures[i - 1];
        const BoundFigure& high = figures[i];
        if (width <= high.width)
        {
            const double part = std::log(width / low.width) / std::log(high.width / low.width);
            return low.error + part * (high.error - low.error);
        }
    }
    return figures.back().error;
}

/// stroke_outline/README.md, shapes of 20 pixels.
double StrokesBound(double width)
{
    return width < 8.0 ? 0.0125 : 0.004;
}

/// wide_outline/README.md: the star's column, or the needle's for parts as thin as one.
double DistancesBound(double width, double thickness)
{
    constexpr BoundFigure k_Star[] = {{1, 0.063}, {2, 0.051}, {8, 0.030}, {32, 0.009}};
    constexpr BoundFigure k_Needle[] = {{1, 0.227}, {2, 0.118}, {8, 0.032}, {32, 0.009}};
    return BoundBetween(thickness < 2.0 ? std::span<const BoundFigure>(k_Needle) : k_Star, width);
}

/// translucent_outline/README.md: within a quarter of a pixel; and two edges that are as good as
/// samples make them, a quarter of a pixel off in the mean for one.
double HullBound(double width, int samples)
{
    return (0.25 + 2.0 * 1.27 * 0.25 / samples) / (width + 1.0);
}

/// What a README says of shapes like those that it was measured on.
std::optional<double> StatedBound(const std::string& name, const ExtremeCase& extreme,
                                  const ShapeFacts& shape)
{
    const double width = extreme.width;
    if (name == "Strokes")
    {
        return StrokesBound(width);
    }
    if ((name == "Separable" || name == "Jump flood") && shape.thickness >= k_Hair)
    {
        return DistancesBound(width, shape.thickness);
    }
    if (name == "Auto")
    {
        return std::max(StrokesBound(width), DistancesBound(width, shape.thickness));
    }
    // The techniques below cull by the way triangles go round; their READMEs mean whole outlines.
    const Untidiness mesh = extreme.untidiness;
    if (mesh == Untidiness::TurnedAtRandom || mesh == Untidiness::Soup || mesh == Untidiness::Open)
    {
        return std::nullopt;
    }
    // "Concave objects": a hull that closes the hole is not the outline's.
    if (name == "Inflated" && width >= 1.0 && width < 0.5 * shape.thickness)
    {
        return HullBound(width, extreme.samples);
    }
    const bool isOrdinary = width >= 1.0 && shape.thickness >= 2.0;
    // outlines.md, §6: a line of 2 pixels on whole silhouettes.
    if (name == "Screen space" && isOrdinary && width <= 2.0)
    {
        return 0.28;
    }
    // Its README: as wide inside as outside, 0.9 of what is asked; a cross, not a circle.
    if (name == "Mask difference" && isOrdinary && width < shape.thickness)
    {
        return 0.6;
    }
    // Its README: steps of 1, 0.69, 0.18 and 0.02 on 1/7, 2/7, 2/7 and 2/7 of the width.
    if (name == "Selection" && isOrdinary)
    {
        return 0.65;
    }
    return std::nullopt;
}

} // namespace

std::optional<double> ErrorBound(const Technique& technique, const ExtremeCase& extreme,
                                 const ShapeFacts& shape)
{
    const auto pixels = static_cast<double>(std::max<std::size_t>(shape.comparedPixels, 1));
    std::optional<double> bound = StatedBound(technique.name, extreme, shape);
    if (bound)
    {
        const bool isSmall = shape.size < k_SmallestShape;
        const double corners =
            isSmall ? k_CornerError * static_cast<double>(shape.borderPixels) : 0.0;
        *bound += (0.5 + corners) / pixels;
    }
    return bound;
}

} // namespace limn::study
