#pragma once

#include "report/truth/Silhouette.h"

#include <cstddef>
#include <vector>

namespace limn
{
struct Image;
}

namespace limn::study
{

/// A picture of numbers 0...1, one for each pixel. Row 0 is at the top.
struct Coverage
{
    int width = 0;
    int height = 0;
    std::vector<double> values;

    Coverage() = default;
    Coverage(int w, int h)
        : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h))
    {
    }
    double& At(int x, int y) { return values[Index(x, y)]; }
    double At(int x, int y) const { return values[Index(x, y)]; }
    double Sum() const;

private:
    std::size_t Index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

/// Returns one channel of an R8_UNorm, R8G8B8A8 or R16G16B16A16_SFloat image as numbers. Nothing is
/// decoded from sRGB.
/// @throws std::invalid_argument for other formats
Coverage ChannelOf(const Image& image, int channel);

enum class OutlineSide
{
    Outer,
    Inner,
    Centred
};

/// The points of an outline, by their signed distance to the silhouette's border.
struct OutlineBand
{
    double width = 0.0; ///< in pixels
    OutlineSide side = OutlineSide::Outer;
    /// The distance of the line from the border, in pixels: inwards for Inner, else outwards.
    double gap = 0.0;

    double Low() const;
    double High() const;
};

/// Returns the part of each pixel's square in which the signed distance is between the band's ends.
/// Pixels that an end crosses are cut into 2^levels x 2^levels squares. Across the smallest squares
/// an end is a straight line.
Coverage ExactOutlineCoverage(const Silhouette& silhouette, const OutlineBand& band, int width,
                              int height, int levels = 4);
/// Returns the part of each pixel's square that the silhouette covers.
Coverage ExactFillCoverage(const Silhouette& silhouette, int width, int height, int levels = 4);

/// The errors of an outline's alpha. They are taken over the pixels in the measured or the exact
/// outline, since the rest of the picture would hide them.
struct OutlineScore
{
    double meanAbsoluteError = 0.0;
    double rootMeanSquare = 0.0;
    double largest = 0.0;
    double percentile99 = 0.0;
    double intersectionOverUnion = 1.0; ///< of the pixels above one half
    double areaRatio = 1.0;             ///< measured : exact
    double widthBias = 0.0;             ///< areaRatio - 1
    /// The sum of alpha / perimeter, in pixels; 0 if no perimeter was given.
    double effectiveWidth = 0.0;
    std::size_t bandPixels = 0;
    std::size_t badValues = 0; ///< NaN, infinite or outside 0...1 by more than 1e-3
};
/// @throws std::invalid_argument if sizes differ
OutlineScore ScoreOutline(const Coverage& measured, const Coverage& exact, double perimeter = 0.0);

/// The distance, in pixels, of the places where alpha crosses one half, between two neighbour
/// pixels, from the true end of the outline. It is positive if they are too far from the
/// silhouette's inside.
struct ContourScore
{
    double mean = 0.0;
    double spread = 0.0;  ///< the standard deviation: how uneven the line's end is
    double largest = 0.0; ///< the largest absolute distance
    std::size_t crossings = 0;
};
struct ContourScores
{
    ContourScore low;  ///< the end nearer to the silhouette's inside
    ContourScore high; ///< the other one
};
ContourScores ScoreContours(const Coverage& measured, const Silhouette& silhouette,
                            const OutlineBand& band);

/// Returns the distance, in pixels, between the places where alpha crosses one half in two
/// pictures. It is the greatest distance from such a place in either picture to the nearest one in
/// the other. It is 0 if neither picture has any, and infinite if only one has.
/// @throws std::invalid_argument if sizes differ
double HausdorffDistance(const Coverage& a, const Coverage& b);

/// Returns the flicker: the change of the error of an outline's alpha from one frame to the next,
/// on average over the pixels that are in an outline of either frame. Motion alone, which the drawn
/// outline follows as the exact one does, does not count.
/// @throws std::invalid_argument if sizes differ
double MeanErrorChange(const Coverage& measuredBefore, const Coverage& exactBefore,
                       const Coverage& measured, const Coverage& exact);

} // namespace limn::study
