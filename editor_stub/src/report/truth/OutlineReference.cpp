#include "report/truth/OutlineReference.h"

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <iterator>
#include <limits>
#include <limn/core/Image.h>
#include <stdexcept>

namespace limn::study
{

namespace
{

/// The part of a square of side 1 that is behind a straight line.
/// @param normal    of the line
/// @param distance  of the line from the square's centre, positive if that is behind it
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

/// Fills a picture square by square, halving those in which the answer changes.
class BandFiller
{
public:
    BandFiller(const Silhouette& silhouette, double low, double high, int width, int height,
               int levels)
        : m_Silhouette(silhouette),
          m_Low(low),
          m_High(high),
          m_Smallest(std::ldexp(1.0, -levels)),
          m_Result(width, height)
    {
        for (const double end : {low, high})
        {
            m_Farthest = std::max(m_Farthest, std::isfinite(end) ? std::abs(end) : 0.0);
        }
    }

    Coverage Fill()
    {
        double side = 1.0;
        while (side < m_Result.width || side < m_Result.height)
        {
            side *= 2.0;
        }
        Fill({0.0, 0.0}, side);
        return std::move(m_Result);
    }

private:
    void Fill(const glm::dvec2& corner, double side)
    {
        if (corner.x >= m_Result.width || corner.y >= m_Result.height)
        {
            return;
        }
        const double reach = side * std::sqrt(0.5);
        const glm::dvec2 center = corner + side / 2.0;
        glm::dvec2 nearest = center;
        const double distance =
            m_Silhouette.SignedDistance(center, m_Farthest + reach + 1.0, &nearest);
        const auto isSame = [&](double end)
        {
            return std::abs(distance - end) > reach;
        };
        if (isSame(m_Low) && isSame(m_High))
        {
            Add(corner, side, distance > m_Low && distance < m_High ? 1.0 : 0.0);
        }
        else if (side <= m_Smallest)
        {
            const double length = glm::distance(center, nearest);
            const glm::dvec2 normal =
                length > 1e-9 ? (center - nearest) / length : glm::dvec2(1.0, 0.0);
            const auto within = [&](double end)
            {
                return PixelCoverage(normal, (end - distance) / side);
            };
            Add(corner, side, within(m_High) - within(m_Low));
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
        if (value == 0.0)
        {
            return;
        }
        if (side <= 1.0)
        {
            m_Result.At(static_cast<int>(corner.x), static_cast<int>(corner.y)) +=
                value * side * side;
            return;
        }
        const int endX = std::min(m_Result.width, static_cast<int>(corner.x + side));
        const int endY = std::min(m_Result.height, static_cast<int>(corner.y + side));
        for (int y = static_cast<int>(corner.y); y < endY; ++y)
        {
            for (int x = static_cast<int>(corner.x); x < endX; ++x)
            {
                m_Result.At(x, y) = value;
            }
        }
    }

    const Silhouette& m_Silhouette;
    double m_Low;
    double m_High;
    double m_Smallest;
    double m_Farthest = 0.0;
    Coverage m_Result;
};

constexpr double k_Nothing = 0.5 / 255.0; ///< what 8 bits round to 0

void RequireSameSize(const Coverage& a, const Coverage& b)
{
    if (a.width != b.width || a.height != b.height)
    {
        throw std::invalid_argument("the outlines' sizes differ");
    }
}

void AddCrossing(ContourScore& score, double error)
{
    score.mean += error;
    score.spread += error * error;
    score.largest = std::max(score.largest, std::abs(error));
    ++score.crossings;
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
                     {
                         nearest = std::min(nearest, glm::distance(place, to[index]));
                         return nearest;
                     });
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
    return BandFiller(silhouette, band.Low(), band.High(), width, height, levels).Fill();
}

Coverage ExactFillCoverage(const Silhouette& silhouette, int width, int height, int levels)
{
    constexpr double k_Everywhere = -std::numeric_limits<double>::infinity();
    return BandFiller(silhouette, k_Everywhere, 0.0, width, height, levels).Fill();
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
    score.widthBias = score.areaRatio - 1.0;
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
        AddCrossing(isLow ? scores.low : scores.high, distance - (isLow ? low : high));
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
