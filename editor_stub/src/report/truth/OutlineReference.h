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

/// Numbers 0...1, one a pixel, row 0 at the top.
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

/// One channel of an R8_UNorm, R8G8B8A8 or R16G16B16A16_SFloat image as numbers; nothing is
/// decoded from sRGB.
/// @throws std::invalid_argument for other formats
Coverage ChannelOf(const Image& image, int channel);

enum class OutlineSide
{
    Outer,
    Inner,
    Centred
};

/// Which points an outline is made of, by their signed distance to the silhouette's border.
struct OutlineBand
{
    double width = 0.0; ///< pixels
    OutlineSide side = OutlineSide::Outer;
    double gap = 0.0; ///< pixels the line keeps off the border: inwards for Inner, else outwards

    double Low() const;
    double High() const;
};

/// The part of each pixel's square in which the signed distance is between the band's ends.
/// Pixels that an end crosses are cut into 2^levels x 2^levels squares, and an end is a straight
/// line across the smallest.
Coverage ExactOutlineCoverage(const Silhouette& silhouette, const OutlineBand& band, int width,
                              int height, int levels = 4);
/// The part of each pixel's square that the silhouette covers.
Coverage ExactFillCoverage(const Silhouette& silhouette, int width, int height, int levels = 4);

/// How far an outline's alpha is off. Errors count pixels that are in the outline, the measured or
/// the exact one: the rest of the picture would hide them.
struct OutlineScore
{
    double meanAbsoluteError = 0.0;
    double rootMeanSquare = 0.0;
    double largest = 0.0;
    double percentile99 = 0.0;
    double intersectionOverUnion = 1.0; ///< of the pixels above one half
    double areaRatio = 1.0;             ///< measured : exact
    double widthBias = 0.0;             ///< areaRatio - 1
    double effectiveWidth = 0.0; ///< pixels: sum of alpha / perimeter; 0 if no perimeter was given
    std::size_t bandPixels = 0;
    std::size_t badValues = 0; ///< NaN, infinite or outside 0...1 by more than 1e-3
};
/// @throws std::invalid_argument if sizes differ
OutlineScore ScoreOutline(const Coverage& measured, const Coverage& exact, double perimeter = 0.0);

/// How far the places where alpha crosses one half, between two neighbour pixels, are from where
/// the outline ends in truth, pixels; positive = too far from the silhouette's inside.
struct ContourScore
{
    double mean = 0.0;
    double spread = 0.0;  ///< standard deviation: how uneven the line's end is
    double largest = 0.0; ///< absolute
    std::size_t crossings = 0;
};
struct ContourScores
{
    ContourScore low;  ///< the end nearer to the silhouette's inside
    ContourScore high; ///< the other one
};
ContourScores ScoreContours(const Coverage& measured, const Silhouette& silhouette,
                            const OutlineBand& band);

/// How far the places where alpha crosses one half are apart, pixels: the greatest distance from
/// one of either picture to the nearest one of the other. 0 if neither has any, infinite if one
/// has.
/// @throws std::invalid_argument if sizes differ
double HausdorffDistance(const Coverage& a, const Coverage& b);

/// How much the error of an outline's alpha changes from one frame to the next, on average over the
/// pixels that are in an outline of either: what flickers. Motion alone, followed by the drawn
/// outline as by the exact one, counts for nothing.
/// @throws std::invalid_argument if sizes differ
double MeanErrorChange(const Coverage& measuredBefore, const Coverage& exactBefore,
                       const Coverage& measured, const Coverage& exact);

} // namespace limn::study
