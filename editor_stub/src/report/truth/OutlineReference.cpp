#include "report/truth/OutlineReference.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>

namespace limn::study
{

namespace
{

/// Fills a picture square by square, halving those in which the answer changes.
struct BandFiller
{
    const Silhouette& silhouette;
    double low;
    double high;
    double smallest; ///< side of a square
    double farthest; ///< the greater distance of the two ends, where it is finite
    Coverage result;

    void Fill(const glm::dvec2& corner, double side)
    {
        if (corner.x >= result.width || corner.y >= result.height)
        {
            return;
        }
        const double reach = side * std::sqrt(0.5);
        const glm::dvec2 center = corner + side / 2.0;
        glm::dvec2 nearest = center;
        const double distance = silhouette.SignedDistance(center, farthest + reach + 1.0, &nearest);
        const auto isSame = [&](double end)
        {
            return std::abs(distance - end) > reach;
        };
        if (isSame(low) && isSame(high))
        {
            Add(corner, side, distance > low && distance < high ? 1.0 : 0.0);
        }
        else if (side <= smallest)
        {
            const double length = glm::distance(center, nearest);
            const glm::dvec2 normal =
                length > 1e-9 ? (center - nearest) / length : glm::dvec2(1.0, 0.0);
            const auto within = [&](double end)
            {
                return PixelCoverage(normal, (end - distance) / side);
            };
            Add(corner, side, within(high) - within(low));
        }
        else
        {
            const double half = side / 2.0;
            for (const glm::dvec2 step : {glm::dvec2(0.0), {half, 0.0}, {0.0, half}, {half, half}})
            {
                Fill(corner + step, half);
            }
        }
    }

    void Add(const glm::dvec2& corner, double side, double value)
    {
        const double part = value * std::min(side * side, 1.0); // of each pixel
        const int endX = std::min(result.width, static_cast<int>(std::ceil(corner.x + side)));
        const int endY = std::min(result.height, static_cast<int>(std::ceil(corner.y + side)));
        for (int y = static_cast<int>(corner.y); y < endY; ++y)
        {
            for (int x = static_cast<int>(corner.x); x < endX; ++x)
            {
                result.At(x, y) += part;
            }
        }
    }
};

Coverage FillBand(const Silhouette& silhouette, double low, double high, int width, int height,
                  int levels)
{
    const double farthest = std::max(std::isfinite(low) ? std::abs(low) : 0.0,
                                     std::isfinite(high) ? std::abs(high) : 0.0);
    BandFiller filler{
        silhouette, low, high, std::ldexp(1.0, -levels), farthest, Coverage(width, height)};
    filler.Fill({0.0, 0.0}, std::bit_ceil(static_cast<unsigned>(std::max(width, height))));
    return std::move(filler.result);
}

constexpr int k_PlacesPerSide = 4; ///< of a pixel

/// Returns the nearness of a triangle at a point; less than 0 outside of it.
double NearnessOf(const DepthTriangle& triangle, const glm::dvec2& point)
{
    const std::array<glm::dvec2, 3> corners{triangle[0], triangle[1], triangle[2]};
    if (!IsInTriangle(corners, point))
    {
        return -1.0;
    }
    const double area = Cross(corners[1] - corners[0], corners[2] - corners[0]);
    double nearness = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec2& begin = corners[(i + 1) % 3];
        const double part = Cross(corners[(i + 2) % 3] - begin, point - begin); // times area
        nearness += part / area * triangle[i].z;
    }
    return std::max(nearness, 0.0);
}

constexpr double k_Nothing = 0.5 / 255.0; ///< what 8 bits round to 0

void RequireSameSize(const Coverage& a, const Coverage& b)
{
    if (a.width != b.width || a.height != b.height)
    {
        throw std::invalid_argument("the outlines' sizes differ");
    }
}

/// Returns the places between two neighbour pixels where alpha crosses one half.
std::vector<glm::dvec2> Crossings(const Coverage& coverage)
{
    std::vector<glm::dvec2> places;
    const auto look = [&](int x, int y, int dx, int dy)
    {
        if (x + dx >= coverage.width || y + dy >= coverage.height)
        {
            return;
        }
        const double here = coverage.At(x, y) - 0.5;
        const double there = coverage.At(x + dx, y + dy) - 0.5;
        if ((here > 0.0) != (there > 0.0))
        {
            places.push_back(glm::dvec2(x + 0.5, y + 0.5) +
                             here / (here - there) * glm::dvec2(dx, dy));
        }
    };
    coverage.ForEach(
        [&](int x, int y)
        {
            look(x, y, 1, 0);
            look(x, y, 0, 1);
        });
    return places;
}

/// The greatest distance from one of `from` to the nearest one of `to`.
double Farthest(const std::vector<glm::dvec2>& from, const std::vector<glm::dvec2>& to)
{
    std::vector<Box> places;
    std::ranges::transform(to, std::back_inserter(places),
                           [](const glm::dvec2& place) {
                               return Box{place, place};
                           });
    const BoxTree tree(std::move(places));
    double farthest = 0.0;
    for (const glm::dvec2& place : from)
    {
        double nearest = std::numeric_limits<double>::infinity();
        tree.Nearest(place, nearest,
                     [&](std::size_t index)
                     { nearest = std::min(nearest, glm::distance(place, to[index])); });
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

} // namespace

double Coverage::Sum() const
{
    return std::accumulate(values.begin(), values.end(), 0.0);
}

double Coverage::Sample(double u, double v, int channel) const
{
    const double x = u * width - 0.5;
    const double y = v * height - 0.5;
    const double x0 = std::floor(x);
    const double y0 = std::floor(y);
    const auto texel = [&](double tx, double ty)
    {
        return At(std::clamp(static_cast<int>(tx), 0, width - 1),
                  std::clamp(static_cast<int>(ty), 0, height - 1), channel);
    };
    const double fx = x - x0;
    const double fy = y - y0;
    return (texel(x0, y0) * (1 - fx) + texel(x0 + 1, y0) * fx) * (1 - fy) +
           (texel(x0, y0 + 1) * (1 - fx) + texel(x0 + 1, y0 + 1) * fx) * fy;
}

Coverage ChannelOf(const Image& image, int channel)
{
    const auto channels = static_cast<std::size_t>(ChannelCount(image.format));
    const bool isHalf = image.format == GraphicsFormat::R16G16B16A16_SFloat;
    if (!isHalf && BytesPerTexel(image.format) != ChannelCount(image.format))
    {
        throw std::invalid_argument(std::string("no channels of ") + ToString(image.format));
    }
    Coverage result(image.width, image.height);
    for (std::size_t i = 0; i < result.values.size(); ++i)
    {
        const std::size_t at = i * channels + static_cast<std::size_t>(channel);
        if (isHalf)
        {
            std::uint16_t bits = 0;
            std::memcpy(&bits, &image.texels[at * 2], 2);
            result.values[i] = static_cast<double>(glm::unpackHalf1x16(bits));
        }
        else
        {
            result.values[i] = std::to_integer<int>(image.texels[at]) / 255.0;
        }
    }
    return result;
}

double PixelCoverage(const glm::dvec2& normal, double distance)
{
    const double large = std::max(std::abs(normal.x), std::abs(normal.y));
    const double small = std::min(std::abs(normal.x), std::abs(normal.y));
    const double aside = std::abs(distance);
    if (aside <= (large - small) / 2.0)
    {
        return 0.5 + distance / large;
    }
    const double rest = std::max((large + small) / 2.0 - aside, 0.0);
    const double outside = rest > 0.0 ? rest * rest / (2.0 * large * small) : 0.0;
    return distance > 0.0 ? 1.0 - outside : outside;
}

double OutlineBand::Low() const
{
    return side == OutlineSide::Outer   ? gap
           : side == OutlineSide::Inner ? -gap - width
                                        : gap - width / 2.0;
}

double OutlineBand::High() const
{
    return Low() + width;
}

Coverage ExactOutlineCoverage(const Silhouette& silhouette, const OutlineBand& band, int width,
                              int height, int levels)
{
    return FillBand(silhouette, band.Low(), band.High(), width, height, levels);
}

Coverage ExactFillCoverage(const Silhouette& silhouette, int width, int height, int levels)
{
    constexpr double k_Everywhere = -std::numeric_limits<double>::infinity();
    return FillBand(silhouette, k_Everywhere, 0.0, width, height, levels);
}

void Surfaces::Add(const std::vector<DepthTriangle>& triangles, std::size_t owner)
{
    for (const DepthTriangle& triangle : triangles)
    {
        const glm::dvec2 a(triangle[0]);
        if (std::abs(Cross(glm::dvec2(triangle[1]) - a, glm::dvec2(triangle[2]) - a)) > 1e-12)
        {
            m_Triangles.push_back(triangle);
            m_Owners.push_back(owner);
        }
    }
}

void Surfaces::Finish()
{
    m_Tree = TreeOf(m_Triangles);
}

Surfaces::Hit Surfaces::NearestAt(const glm::dvec2& point) const
{
    Hit nearest;
    m_Tree.AnyTouching(Box{point, point},
                       [&](std::size_t index)
                       {
                           const double nearness = NearnessOf(m_Triangles[index], point);
                           if (nearness >= nearest.nearness)
                           {
                               nearest = {nearness, m_Owners[index]};
                           }
                           return false;
                       });
    return nearest;
}

SeenOutline SeenOutlineCoverage(const Coverage& whole, const Silhouette& silhouette, double width,
                                const Surfaces& own, const Surfaces& others, HiddenAt where)
{
    SeenOutline result{whole, {}};
    if (others.isEmpty())
    {
        return result;
    }
    std::set<std::size_t> hiding;
    const auto isSeen = [&](const glm::dvec2& place, const glm::dvec2& nearest)
    {
        constexpr double k_NotInFront = 1.001;
        const Surfaces::Hit other = others.NearestAt(where == HiddenAt::Border ? nearest : place);
        const bool isHidden = other.owner != Surfaces::k_NoOwner &&
                              other.nearness > own.NearestAt(nearest).nearness * k_NotInFront;
        if (isHidden)
        {
            hiding.insert(other.owner);
        }
        return !isHidden;
    };
    // Returns the part of a pixel's outline that is seen, 0...1.
    const auto partOf = [&](int x, int y)
    {
        constexpr int k_Places = k_PlacesPerSide * k_PlacesPerSide;
        int inBand = 0;
        int seenInBand = 0;
        int seen = 0;
        for (int i = 0; i < k_Places; ++i)
        {
            const glm::dvec2 step(i % k_PlacesPerSide + 0.5, i / k_PlacesPerSide + 0.5);
            const glm::dvec2 place = glm::dvec2(x, y) + step / static_cast<double>(k_PlacesPerSide);
            glm::dvec2 nearest = place;
            const double distance = silhouette.SignedDistance(place, width + 2.0, &nearest);
            const int isPlaceSeen = isSeen(place, nearest) ? 1 : 0;
            const int isInBand = distance > 0.0 && distance < width ? 1 : 0;
            inBand += isInBand;
            seenInBand += isInBand * isPlaceSeen;
            seen += isPlaceSeen;
        }
        // A sliver of the outline may pass between all places.
        return inBand > 0 ? static_cast<double>(seenInBand) / inBand
                          : static_cast<double>(seen) / k_Places;
    };
    whole.ForEach(
        [&](int x, int y)
        {
            if (whole.At(x, y) > 0.0)
            {
                result.seen.At(x, y) *= partOf(x, y);
            }
        });
    result.hiding.assign(hiding.begin(), hiding.end());
    return result;
}

OutlineScore ScoreOutline(const Coverage& measured, const Coverage& exact, double perimeter)
{
    RequireSameSize(measured, exact);
    OutlineScore score;
    std::vector<double> errors;
    std::size_t both = 0;
    std::size_t either = 0;
    double squares = 0.0;
    for (std::size_t i = 0; i < exact.values.size(); ++i)
    {
        double value = measured.values[i];
        if (!std::isfinite(value) || value < -1e-3 || value > 1.0 + 1e-3)
        {
            ++score.badValues;
            value = std::isfinite(value) ? value : 0.0;
        }
        both += value > 0.5 && exact.values[i] > 0.5 ? 1 : 0;
        either += value > 0.5 || exact.values[i] > 0.5 ? 1 : 0;
        if (value > k_Nothing || exact.values[i] > k_Nothing)
        {
            errors.push_back(std::abs(value - exact.values[i]));
            squares += errors.back() * errors.back();
        }
    }
    score.bandPixels = errors.size();
    score.areaRatio = exact.Sum() > 0.0 ? measured.Sum() / exact.Sum() : 1.0;
    score.effectiveWidth = perimeter > 0.0 ? measured.Sum() / perimeter : 0.0;
    score.intersectionOverUnion =
        either > 0 ? static_cast<double>(both) / static_cast<double>(either) : 1.0;
    if (!errors.empty())
    {
        const auto count = static_cast<double>(errors.size());
        std::sort(errors.begin(), errors.end());
        score.meanAbsoluteError = std::accumulate(errors.begin(), errors.end(), 0.0) / count;
        score.rootMeanSquare = std::sqrt(squares / count);
        score.largest = errors.back();
        score.percentile99 = errors[static_cast<std::size_t>(0.99 * (count - 1.0))];
    }
    return score;
}

ContourScores ScoreContours(const Coverage& measured, const Silhouette& silhouette,
                            const OutlineBand& band)
{
    const double low = band.Low();
    const double high = band.High();
    const double limit = std::max(std::abs(low), std::abs(high)) + 64.0;
    ContourScores scores;
    for (const glm::dvec2& place : Crossings(measured))
    {
        const double distance = silhouette.SignedDistance(place, limit);
        const bool isLow = std::abs(distance - low) < std::abs(distance - high);
        const double error = distance - (isLow ? low : high);
        ContourScore& score = isLow ? scores.low : scores.high;
        score.mean += error;
        score.spread += error * error;
        ++score.crossings;
    }
    for (ContourScore* score : {&scores.low, &scores.high})
    {
        const double count = score->crossings > 0 ? static_cast<double>(score->crossings) : 1.0;
        score->mean /= count;
        score->spread = std::sqrt(std::max(0.0, score->spread / count - score->mean * score->mean));
    }
    return scores;
}

double HausdorffDistance(const Coverage& a, const Coverage& b)
{
    RequireSameSize(a, b);
    const std::vector<glm::dvec2> ofA = Crossings(a);
    const std::vector<glm::dvec2> ofB = Crossings(b);
    return std::max(Farthest(ofA, ofB), Farthest(ofB, ofA));
}

double MeanErrorChange(const Coverage& measuredBefore, const Coverage& exactBefore,
                       const Coverage& measured, const Coverage& exact)
{
    RequireSameSize(measured, exact);
    RequireSameSize(measuredBefore, exact);
    RequireSameSize(exactBefore, exact);
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < exact.values.size(); ++i)
    {
        const double before = measuredBefore.values[i] - exactBefore.values[i];
        const double now = measured.values[i] - exact.values[i];
        const bool isOutline =
            std::max({measured.values[i], exact.values[i], measuredBefore.values[i],
                      exactBefore.values[i]}) > k_Nothing;
        sum += isOutline ? std::abs(now - before) : 0.0;
        count += isOutline ? 1 : 0;
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

} // namespace limn::study
