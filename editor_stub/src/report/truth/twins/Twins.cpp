#include "report/truth/twins/Twins.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limn/features/MaskDifferenceOutline.h>
#include <limn/features/SelectionOutline.h>
#include <numeric>

namespace limn::study
{

namespace
{

/// The distance for which PixelCoverage gives that.
double BoxDepth(const glm::dvec2& normal, double coverage)
{
    const double large = std::max(std::abs(normal.x), std::abs(normal.y));
    const double small = std::min(std::abs(normal.x), std::abs(normal.y));
    const double less = std::min(coverage, 1.0 - coverage);
    const double outside = less * 2.0 * large < small
                               ? (large + small) * 0.5 - std::sqrt(2.0 * large * small * less)
                               : (0.5 - less) * large;
    return coverage > 0.5 ? outside : -outside;
}

const glm::dvec2 k_FarAway(1e9);

glm::dvec2 Nearer(const glm::dvec2& a, const glm::dvec2& b)
{
    return glm::dot(b, b) < glm::dot(a, a) ? b : a;
}

/// EdgePlace of EdgeSeeds.hlsl.
struct TwinSeed
{
    bool isEdge = false;
    glm::dvec2 seed{0.0};
    glm::dvec2 outwards{0.0};
    double inside = 0.0;
};

TwinSeed FindEdge(const std::array<double, 9>& mask)
{
    const double own = mask[4];
    const double least = std::min({mask[1], mask[3], mask[5], mask[7]});
    TwinSeed place;
    place.isEdge = own > 0.0 && (own < 1.0 || least == 0.0);
    place.inside = own;
    const glm::dvec2 inwards(mask[2] + mask[8] - mask[0] - mask[6] + 2.0 * (mask[5] - mask[3]),
                             mask[6] + mask[8] - mask[0] - mask[2] + 2.0 * (mask[7] - mask[1]));
    if (!place.isEdge || glm::dot(inwards, inwards) < 1e-4)
    {
        return place;
    }
    const glm::dvec2 outwards = -glm::normalize(inwards);
    const double sum = std::accumulate(mask.begin(), mask.end(), 0.0);
    double depth = 3.0 * BoxDepth(outwards, sum / 9.0);
    const double inside = PixelCoverage(outwards, depth);
    if (std::abs(inside - own) < 0.2)
    {
        place.inside = inside;
        place.outwards = outwards;
    }
    else
    {
        depth = BoxDepth(outwards, own);
    }
    place.seed = outwards * depth;
    return place;
}

/// The seeds of a picture and the textures in which the nearest ones are found. Places beyond the
/// picture belong to it as far as the outline reaches.
class DistanceTwin
{
public:
    DistanceTwin(const Silhouette& silhouette, double width, int pictureWidth, int pictureHeight)
        : m_Width(std::max(width, 1e-3)),
          m_Reach(static_cast<int>(std::ceil(m_Width + 1.0))),
          m_Margin(m_Reach + 2),
          m_Size(pictureWidth + 2 * m_Margin, pictureHeight + 2 * m_Margin),
          m_Mask(m_Size.x, m_Size.y),
          m_Seeds(m_Mask.values.size())
    {
        MakeSeeds(silhouette);
    }

    Coverage Draw(bool isFlood) const
    {
        const std::vector<glm::dvec2> nearest = isFlood ? Flood() : Rows();
        Coverage alpha(m_Size.x - 2 * m_Margin, m_Size.y - 2 * m_Margin);
        alpha.ForEach(
            [&](int x, int y)
            {
                const glm::ivec2 texel(x + m_Margin, y + m_Margin);
                alpha.At(x, y) = AlphaAt(texel, nearest[IndexOf(texel)]);
            });
        return alpha;
    }

private:
    std::size_t IndexOf(const glm::ivec2& texel) const
    {
        const glm::ivec2 within = glm::clamp(texel, glm::ivec2(0), m_Size - 1);
        return static_cast<std::size_t>(within.y * m_Size.x + within.x);
    }

    void MakeSeeds(const Silhouette& silhouette)
    {
        // These are the places of Vulkan's four samples in a texel.
        constexpr double k_Places[4][2] = {
            {0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
        ForEach(
            [&](const glm::ivec2& texel)
            {
                for (const auto& place : k_Places)
                {
                    const glm::dvec2 at =
                        glm::dvec2(texel - m_Margin) + glm::dvec2(place[0], place[1]);
                    m_Mask.values[IndexOf(texel)] += silhouette.Contains(at) ? 0.25 : 0.0;
                }
            });
        ForEach(
            [&](const glm::ivec2& texel)
            {
                std::array<double, 9> around{};
                for (int i = 0; i < 9; ++i)
                {
                    around[static_cast<std::size_t>(i)] =
                        m_Mask.values[IndexOf(texel + glm::ivec2(i % 3 - 1, i / 3 - 1))];
                }
                m_Seeds[IndexOf(texel)] = FindEdge(around);
            });
    }

    template <typename Each>
    void ForEach(const Each& each) const
    {
        m_Mask.ForEach([&](int x, int y) { each(glm::ivec2(x, y)); });
    }

    /// Returns the seed, or none if no texture would keep it.
    glm::dvec2 Kept(const glm::dvec2& seed) const
    {
        const double range = m_Reach + 1.0;
        return std::abs(seed.x) < range && std::abs(seed.y) < range ? seed : k_FarAway;
    }

    std::vector<glm::dvec2> Flood() const
    {
        std::vector<glm::dvec2> nearest(m_Seeds.size());
        std::ranges::transform(m_Seeds, nearest.begin(),
                               [](const TwinSeed& seed)
                               { return seed.isEdge ? seed.seed : k_FarAway; });
        std::vector<int> steps = {1};
        for (auto step = static_cast<int>(std::bit_ceil(static_cast<unsigned>(m_Reach) + 1) / 2);
             step > 0; step /= 2)
        {
            steps.push_back(step);
        }
        for (const int step : steps)
        {
            std::vector<glm::dvec2> next(nearest.size());
            ForEach(
                [&](const glm::ivec2& texel)
                {
                    glm::dvec2 best = k_FarAway;
                    for (int i = 0; i < 9; ++i)
                    {
                        const glm::ivec2 there =
                            glm::clamp(texel + step * glm::ivec2(i % 3 - 1, i / 3 - 1),
                                       glm::ivec2(0), m_Size - 1);
                        best = Nearer(best, glm::dvec2(there - texel) + nearest[IndexOf(there)]);
                    }
                    next[IndexOf(texel)] = Kept(best);
                });
            nearest = std::move(next);
        }
        return nearest;
    }

    /// Returns the seeds of the rows as ColumnSeeds and RowSeed do: for each column the nearest one
    /// to a place on its right and on its left.
    std::vector<glm::dvec2> Rows() const
    {
        const glm::dvec2 aside(0.5 * m_Width, 0.0);
        std::vector<std::array<glm::dvec2, 2>> columns(m_Seeds.size());
        ForEach(
            [&](const glm::ivec2& texel)
            {
                glm::dvec2 fromRight = k_FarAway;
                glm::dvec2 fromLeft = k_FarAway;
                for (int y = std::max(-m_Reach, -texel.y);
                     y <= std::min(m_Reach, m_Size.y - 1 - texel.y); ++y)
                {
                    const TwinSeed& there = m_Seeds[IndexOf(texel + glm::ivec2(0, y))];
                    const glm::dvec2 seed =
                        there.isEdge ? there.seed + glm::dvec2(0.0, y) : k_FarAway;
                    fromRight = Nearer(fromRight, seed - aside);
                    fromLeft = Nearer(fromLeft, seed + aside);
                }
                columns[IndexOf(texel)] = {Kept(fromRight + aside), Kept(fromLeft - aside)};
            });
        std::vector<glm::dvec2> nearest(m_Seeds.size(), k_FarAway);
        ForEach(
            [&](const glm::ivec2& texel)
            {
                for (int x = std::max(-m_Reach, -texel.x);
                     x <= std::min(m_Reach, m_Size.x - 1 - texel.x); ++x)
                {
                    const auto& column = columns[IndexOf(texel + glm::ivec2(x, 0))];
                    nearest[IndexOf(texel)] =
                        Nearer(nearest[IndexOf(texel)], glm::dvec2(x, 0.0) + column[x < 0 ? 0 : 1]);
                }
            });
        return nearest;
    }

    /// Returns the composite's alpha: that of a band from the edge outwards.
    double AlphaAt(const glm::ivec2& texel, const glm::dvec2& toPlace) const
    {
        const double inside = m_Seeds[IndexOf(texel)].inside;
        if (inside >= 1.0 || glm::dot(toPlace, toPlace) > 1e12)
        {
            return 0.0;
        }
        const glm::dvec2 place = glm::floor(glm::dvec2(texel) + 0.5 + toPlace);
        const glm::dvec2 outwards = m_Seeds[IndexOf(glm::ivec2(place))].outwards;
        const glm::dvec2 tangent(-outwards.y, outwards.x);
        const glm::dvec2 toEdge =
            toPlace - tangent * std::clamp(glm::dot(toPlace, tangent), -0.5, 0.5);
        const double away = glm::length(toEdge);
        const glm::dvec2 direction = away > 1e-3 ? toEdge / away : glm::dvec2(1.0, 0.0);
        const double distance = inside > 0.5 ? -away : away;
        return std::clamp(PixelCoverage(direction, m_Width - distance) - inside, 0.0, 1.0);
    }

    double m_Width;
    int m_Reach;
    int m_Margin;
    glm::ivec2 m_Size;
    Coverage m_Mask;
    std::vector<TwinSeed> m_Seeds;
};

/// The distance to the places on the edge of a mask of four samples.
/// @param IsFlood  by jump flooding, else by columns and then rows
template <bool IsFlood>
Coverage WideTwin(const Silhouette& silhouette, double width, int pictureWidth, int pictureHeight)
{
    return DistanceTwin(silhouette, width, pictureWidth, pictureHeight).Draw(IsFlood);
}

/// Strokes along the silhouette, which may have no edges inside.
Coverage StrokeTwin(const Silhouette& silhouette, double width, int pictureWidth, int pictureHeight)
{
    Coverage alpha(pictureWidth, pictureHeight);
    Coverage correction(pictureWidth, pictureHeight);
    const auto isOwn = [&](const glm::dvec2& pixel)
    {
        return silhouette.Contains(glm::floor(pixel) + 0.5);
    };
    for (auto [a, b] : silhouette.border())
    {
        glm::dvec2 along = glm::normalize(b - a);
        glm::dvec2 outward(along.y, -along.x);
        if (silhouette.Contains(0.5 * (a + b) + 1e-6 * outward))
        {
            outward = -outward;
        }
        const double reach = glm::distance(a, b);
        const double extent = 0.5 * (std::abs(along.x) + std::abs(along.y));
        const glm::ivec2 low(glm::max(glm::floor(glm::min(a, b) - width - 2.0), 0.0));
        const glm::ivec2 high(glm::min(glm::ceil(glm::max(a, b) + width + 2.0),
                                       glm::dvec2(pictureWidth, pictureHeight)));
        for (int y = low.y; y < high.y; ++y)
        {
            for (int x = low.x; x < high.x; ++x)
            {
                const glm::dvec2 pixel(x + 0.5, y + 0.5);
                const double place = glm::dot(pixel - a, along);
                const double across = glm::dot(pixel - a, outward);
                if (across < -1.0 || across > width + 1.0)
                {
                    continue; // beside the stroke's quad
                }
                const double onEdge = std::clamp(place, 0.0, reach);
                const glm::dvec2 apart = pixel - a - along * onEdge;
                const double away = glm::length(apart);
                const bool isInside = across < 0.0 && place == onEdge && isOwn(pixel);
                const double covered = PixelCoverage(away > 1e-4 ? apart / away : outward,
                                                     width - (isInside ? -away : away));
                alpha.At(x, y) = std::max(alpha.At(x, y), covered);
                const double share = (std::clamp(place + extent, 0.0, reach) -
                                      std::clamp(place - extent, 0.0, reach)) /
                                     (2.0 * extent);
                if (share > 0.0 && std::abs(across) < 0.71 && !isOwn(a + along * onEdge + outward))
                {
                    const bool isBehind = std::abs(across) < 0.01 ? isOwn(pixel) : across < 0.0;
                    const double beyond = PixelCoverage(outward, across);
                    correction.At(x, y) += (isBehind ? -beyond : 1.0 - beyond) * share;
                }
            }
        }
    }
    alpha.ForEach(
        [&](int x, int y)
        {
            const double own = silhouette.Contains({x + 0.5, y + 0.5}) ? 1.0 : 0.0;
            const double objects = std::clamp(own + correction.At(x, y), 0.0, 1.0);
            alpha.At(x, y) = std::clamp(alpha.At(x, y) - objects, 0.0, 1.0);
        });
    return alpha;
}

/// 1 where the silhouette has the middle of a texel, in all channels.
Field MaskOf(const Silhouette& silhouette, const glm::dvec2& picture, int width, int height,
             int channels)
{
    Field mask{width, height, channels, {}};
    mask.ForEach(
        [&](int x, int y)
        {
            const glm::dvec2 place((x + 0.5) * picture.x / width, (y + 0.5) * picture.y / height);
            mask.values.insert(mask.values.end(), static_cast<std::size_t>(channels),
                               silhouette.Contains(place) ? 1.0 : 0.0);
        });
    return mask;
}

/// The first article's: mask of half the size, Roberts cross, bilinear composite.
Coverage ScreenSpaceTwin(const Silhouette& silhouette, double width, int pictureWidth,
                         int pictureHeight)
{
    const Field mask = MaskOf(silhouette, {pictureWidth, pictureHeight},
                              std::max(pictureWidth / 2, 1), std::max(pictureHeight / 2, 1), 1);
    Field edge = RobertsReference(mask, width);
    std::ranges::transform(edge.values, edge.values.begin(),
                           [](double value) { return std::min(value, 1.0); });
    return CompositeReference(Coverage(pictureWidth, pictureHeight), edge, {1.0, 1.0, 1.0});
}

/// The article on selection: seven blurs of the mask. The device keeps 8 bits behind each, and a
/// mean of four such numbers is half way between two as often as not.
Coverage SelectionTwin(const Silhouette& silhouette, double width, int pictureWidth,
                       int pictureHeight)
{
    SelectionOutline component;
    component.m_OutlineWidth.Override(static_cast<float>(width));
    const Field stencil =
        MaskOf(silhouette, {pictureWidth, pictureHeight}, pictureWidth, pictureHeight, 4);
    Field blur = stencil;
    for (int i = 0; i < component.blurCount(); ++i)
    {
        blur = BlurReference(blur, static_cast<double>(component.tapOffset()));
    }
    return CompositeReference(Coverage(pictureWidth, pictureHeight), stencil, blur,
                              static_cast<double>(component.outlineStrength.value()));
}

/// The article on post-processing: where the mask differs from four texels around.
Coverage MaskDifferenceTwin(const Silhouette& silhouette, double width, int pictureWidth,
                            int pictureHeight)
{
    MaskDifferenceOutline component;
    component.m_OutlineWidth.Override(static_cast<float>(width));
    const int away = static_cast<int>(component.reach());
    Coverage alpha(pictureWidth, pictureHeight);
    // The mask goes on outside of the picture.
    const auto mask = [&](int x, int y)
    {
        return silhouette.Contains({x + 0.5, y + 0.5}) ? 1 : 0;
    };
    alpha.ForEach(
        [&](int x, int y)
        {
            const int sum =
                mask(x, y - away) + mask(x, y + away) + mask(x - away, y) + mask(x + away, y);
            alpha.At(x, y) = sum > 0 && 4 * mask(x, y) != sum ? 1.0 : 0.0;
        });
    return alpha;
}

} // namespace

Field RobertsReference(const Field& mask, double width)
{
    Field edge(mask.width, mask.height);
    const double lower = std::floor(width * 0.5) * 0.5 / mask.width;
    const double upper = std::ceil(width * 0.5) * 0.5 / mask.width;
    const double lowerV = std::floor(width * 0.5) * 0.5 / mask.height;
    const double upperV = std::ceil(width * 0.5) * 0.5 / mask.height;
    mask.ForEach(
        [&](int x, int y)
        {
            const double u = (x + 0.5) / mask.width;
            const double v = (y + 0.5) / mask.height;
            const double tap0 = mask.Sample(u - lower, v + upperV);
            const double tap1 = mask.Sample(u + upper, v + lowerV);
            const double tap2 = mask.Sample(u - lower, v - upperV);
            const double tap3 = mask.Sample(u + upper, v - lowerV);
            edge.At(x, y) = std::hypot(tap1 - tap2, tap0 - tap3);
        });
    return edge;
}

Field CompositeReference(const Field& base, const Field& edge, const std::array<double, 3>& color)
{
    Field result = base;
    base.ForEach(
        [&](int x, int y)
        {
            const double amount = edge.Sample((x + 0.5) / base.width, (y + 0.5) / base.height);
            for (int channel = 0; channel < std::min(3, result.channels); ++channel)
            {
                result.At(x, y, channel) += amount * color[static_cast<std::size_t>(channel)];
            }
        });
    return result;
}

Field BlurReference(const Field& source, double offset)
{
    Field result = source;
    const double du = offset / source.width;
    const double dv = offset / source.height;
    source.ForEach(
        [&](int x, int y)
        {
            const double u = (x + 0.5) / source.width;
            const double v = (y + 0.5) / source.height;
            for (int channel = 0; channel < 4; ++channel)
            {
                const double taps[] = {
                    source.Sample(u - du, v - dv, channel), source.Sample(u + du, v - dv, channel),
                    source.Sample(u + du, v + dv, channel), source.Sample(u - du, v + dv, channel)};
                result.At(x, y, channel) = channel < 3
                                               ? *std::ranges::max_element(taps)
                                               : (taps[0] + taps[1] + taps[2] + taps[3]) / 4.0;
            }
        });
    return result;
}

Field CompositeReference(const Field& source, const Field& stencil, const Field& blur,
                         double strength)
{
    Field result = source;
    source.ForEach(
        [&](int x, int y)
        {
            const bool isInside = stencil.At(x, y, 0) != 0.0 || stencil.At(x, y, 1) != 0.0 ||
                                  stencil.At(x, y, 2) != 0.0;
            const double weight =
                isInside ? 0.0 : std::clamp(blur.At(x, y, 3) - stencil.At(x, y, 3), 0.0, 1.0);
            for (int channel = 0; channel < std::min(3, result.channels); ++channel)
            {
                double& value = result.At(x, y, channel);
                value += weight * (blur.At(x, y, channel) * strength - value);
            }
        });
    return result;
}

Twin FindTwin(const std::string& technique)
{
    const std::pair<const char*, Twin> twins[] = {
        {"Screen space", ScreenSpaceTwin},       {"Selection", SelectionTwin},
        {"Mask difference", MaskDifferenceTwin}, {"Jump flood", WideTwin<true>},
        {"Separable", WideTwin<false>},          {"Strokes", StrokeTwin}};
    const auto found = std::ranges::find(twins, technique, &std::pair<const char*, Twin>::first);
    return found != std::end(twins) ? found->second : Twin();
}

} // namespace limn::study
