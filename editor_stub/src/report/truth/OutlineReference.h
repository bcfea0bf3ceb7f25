#pragma once

#include "report/truth/Silhouette.h"

#include <limn/core/Image.h>
#include <limn/features/Technique.h>

namespace limn::study
{

/// A picture of numbers. Row 0 is at the top. A coverage has one channel, of numbers 0...1.
struct Coverage
{
    int width = 0;
    int height = 0;
    int channels = 1; ///< the numbers of a pixel
    std::vector<double> values;

    Coverage() = default;
    Coverage(int w, int h) : Coverage(w, h, 1, {}) { values.resize(Index(0, h, 0)); }
    Coverage(int w, int h, int c, std::vector<double> v)
        : width(w), height(h), channels(c), values(std::move(v))
    {
    }
    double& At(int x, int y, int channel = 0) { return values[Index(x, y, channel)]; }
    double At(int x, int y, int channel = 0) const { return values[Index(x, y, channel)]; }
    /// Returns a bilinear sample, clamped at the border. u and v are in 0...1; (0, 0) is the top
    /// left corner.
    double Sample(double u, double v, int channel = 0) const;
    double Sum() const;
    /// Calls each(x, y) for all pixels, row by row.
    template <typename Each>
    void ForEach(const Each& each) const
    {
        for (int y = 0; y < height; ++y)
        {
            for (int x = 0; x < width; ++x)
            {
                each(x, y);
            }
        }
    }

private:
    std::size_t Index(int x, int y, int channel) const
    {
        const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x);
        return pixel * static_cast<std::size_t>(channels) + static_cast<std::size_t>(channel);
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

/// Returns the part of a square of side 1 that is behind a straight line.
/// @param normal    of the line, of unit length
/// @param distance  of the line from the square's centre, positive if that is behind it
double PixelCoverage(const glm::dvec2& normal, double distance);

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

/// The surfaces of several objects, asked for the nearest one at a place of the picture.
class Surfaces
{
public:
    static constexpr std::size_t k_NoOwner = ~std::size_t{0};
    struct Hit
    {
        double nearness = 0.0;
        std::size_t owner = k_NoOwner; ///< k_NoOwner where there is no surface
    };

    /// Adds triangles of the object `owner`. Triangles without an area are passed over.
    void Add(const std::vector<DepthTriangle>& triangles, std::size_t owner);
    /// Must be called after the last Add and before the first NearestAt.
    void Finish();
    Hit NearestAt(const glm::dvec2& point) const;
    bool isEmpty() const { return m_Triangles.empty(); }

private:
    std::vector<DepthTriangle> m_Triangles;
    std::vector<std::size_t> m_Owners;
    BoxTree m_Tree;
};

/// The part of an outline that nothing hides.
struct SeenOutline
{
    Coverage seen;
    std::vector<std::size_t> hiding; ///< the owners that hide something, each once, in order
};

/// Divides each pixel of an outline by 4 x 4 places in it. Something hides the outline if it is
/// nearer to the camera than the object by more than a thousandth of the nearness: what touches the
/// object hides nothing.
/// @param whole   the outline of `width` pixels around the silhouette, whatever stands in front
/// @param own     the surfaces of the silhouette's objects
/// @param others  the surfaces that may stand in front
SeenOutline SeenOutlineCoverage(const Coverage& whole, const Silhouette& silhouette, double width,
                                const Surfaces& own, const Surfaces& others, HiddenAt where);

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
    double spread = 0.0; ///< the standard deviation: how uneven the line's end is
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
