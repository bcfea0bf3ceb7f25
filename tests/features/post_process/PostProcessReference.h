#pragma once

#include "features/OutlineGpuReference.h"
#include "shaderlab/library/AcesReference.h"

#include <limn/features/Bloom.h>
#include <limn/features/ColorAdjustments.h>
#include <limn/features/PostProcessRendererFeature.h>
#include <limn/features/Tonemapping.h>

// What URP's effects make of a linear picture, in double precision, without its tables.

namespace limn::test
{

using study::Field;

struct Adjustments
{
    double exposure = 0.0;
    double contrast = 0.0;
    glm::dvec3 filter{1.0}; ///< linear
    double hueShift = 0.0;
    double saturation = 0.0;

    bool isNone() const
    {
        return exposure == 0.0 && contrast == 0.0 && filter == glm::dvec3(1.0) && hueShift == 0.0 &&
               saturation == 0.0;
    }

    void SetOn(ColorAdjustments& component) const
    {
        const auto encoded = [](double c)
        {
            return static_cast<float>(c > 1.0         ? std::pow(c, 1 / 2.2)
                                      : c > 0.0031308 ? 1.055 * std::pow(c, 1 / 2.4) - 0.055
                                                      : c * 12.92);
        };
        component.postExposure.Override(static_cast<float>(exposure));
        component.contrast.Override(static_cast<float>(contrast));
        component.colorFilter.Override(
            {encoded(filter.x), encoded(filter.y), encoded(filter.z), 1.0f});
        component.hueShift.Override(static_cast<float>(hueShift));
        component.saturation.Override(static_cast<float>(saturation));
    }
};

/// A picture of what a function makes of each pixel: (color, u, v), v from the top.
template <typename F>
Field PerPixel(const Field& base, F&& function)
{
    Field result = base;
    for (int y = 0; y < base.height; ++y)
    {
        for (int x = 0; x < base.width; ++x)
        {
            const glm::dvec3 color(base.At(x, y, 0), base.At(x, y, 1), base.At(x, y, 2));
            const glm::dvec3 made =
                function(color, (x + 0.5) / base.width, (y + 0.5) / base.height);
            for (int channel = 0; channel < 3; ++channel)
            {
                result.At(x, y, channel) = made[channel];
            }
        }
    }
    return result;
}

inline glm::dvec3 At(const Field& field, double u, double v)
{
    return {field.Sample(u, v, 0), field.Sample(u, v, 1), field.Sample(u, v, 2)};
}

/// The two blurs that fast approximate antialiasing (T. Lottes, NVIDIA 2011) chooses from, and how
/// far the luminance of the wide one is from leaving the range of the five pixels: below 0,
/// outside.
struct SmoothedPixel
{
    glm::dvec3 narrow{0.0};
    glm::dvec3 wide{0.0};
    double margin = 0.0;
};

/// @param rows  in the order in which the texture stores them, as positions on the device go
inline SmoothedPixel SmoothReference(const Field& rows, int x, int y)
{
    const auto luminance = [](const glm::dvec3& color)
    {
        return glm::dot(color, glm::dvec3(0.2126729, 0.7151522, 0.0721750));
    };
    const auto texel = [&](int column, int row)
    {
        column = std::clamp(column, 0, rows.width - 1);
        row = std::clamp(row, 0, rows.height - 1);
        return glm::clamp(
            glm::dvec3(rows.At(column, row, 0), rows.At(column, row, 1), rows.At(column, row, 2)),
            0.0, 1.0);
    };
    const double northWest = luminance(texel(x - 1, y - 1));
    const double northEast = luminance(texel(x + 1, y - 1));
    const double southWest = luminance(texel(x - 1, y + 1));
    const double southEast = luminance(texel(x + 1, y + 1));
    const double center = luminance(texel(x, y));
    glm::dvec2 direction(-((northWest + northEast) - (southWest + southEast)),
                         (northWest + southWest) - (northEast + southEast));
    const double reduce =
        std::max((northWest + northEast + southWest + southEast) * 0.25 / 8.0, 1.0 / 128.0);
    direction /= std::min(std::abs(direction.x), std::abs(direction.y)) + reduce;
    direction = glm::clamp(direction, -8.0, 8.0);
    const auto tap = [&](double part)
    {
        const double u = (x + 0.5 + part * direction.x) / rows.width;
        const double v = (y + 0.5 + part * direction.y) / rows.height;
        return glm::clamp(At(rows, u, v), 0.0, 1.0);
    };
    SmoothedPixel result;
    result.narrow = (tap(1.0 / 3.0 - 0.5) + tap(2.0 / 3.0 - 0.5)) / 2.0;
    result.wide = result.narrow / 2.0 + (tap(-0.5) + tap(0.5)) / 4.0;
    const auto [least, most] = std::minmax({northWest, northEast, southWest, southEast, center});
    result.margin = std::min(luminance(result.wide) - least, most - luminance(result.wide));
    return result;
}

/// `slope` about 18 % grey in a logarithm: of ARRI for linear colours, or the Academy's.
inline double LogarithmicContrast(double x, double slope, bool isAcademy)
{
    constexpr double middle = 0.4135884;
    if (isAcademy)
    {
        const double foot = std::exp2(-15.0);
        const double y = std::max(x, 0.0);
        const double encoded =
            ((y < foot ? std::log2(foot / 2 + y / 2) : std::log2(y)) + 9.72) / 17.52;
        const double moved = (encoded - middle) * slope + middle;
        const double power = std::exp2(moved * 17.52 - 9.72);
        return moved < (9.72 - 15.0) / 17.52 ? (power - foot / 2) * 2 : std::min(power, 65504.0);
    }
    const double encoded = 0.244161 * std::log10(std::max(5.555556 * x + 0.047996, 0.0)) + 0.386036;
    const double moved = (encoded - middle) * slope + middle;
    return (std::pow(10.0, (moved - 0.386036) / 0.244161) - 0.047996) / 5.555556;
}

/// Hue turned by degrees; the largest and the smallest channel stay.
inline glm::dvec3 TurnedHue(const glm::dvec3& c, double degrees)
{
    const double high = std::max({c.x, c.y, c.z});
    const double low = std::min({c.x, c.y, c.z});
    if (high <= low)
    {
        return c;
    }
    double hue = high == c.x   ? (c.y - c.z) / (high - low)
                 : high == c.y ? (c.z - c.x) / (high - low) + 2
                               : (c.x - c.y) / (high - low) + 4;
    hue = std::fmod(hue + degrees / 60.0 + 12.0, 6.0);
    const double rising = low + (high - low) * (hue - std::floor(hue));
    const double falling = low + high - rising;
    switch (static_cast<int>(hue))
    {
    case 0:
        return {high, rising, low};
    case 1:
        return {falling, high, low};
    case 2:
        return {low, high, rising};
    case 3:
        return {low, falling, high};
    case 4:
        return {rising, low, high};
    default:
        return {high, low, falling};
    }
}

inline glm::dmat3 Rec709ToAces()
{
    return glm::inverse(Ap0ToXyz()) * Adaptation(k_D65, k_D60) * Rec709ToXyz();
}

inline glm::dvec3 TonemapReference(const glm::dvec3& color, TonemappingMode mode)
{
    if (mode == TonemappingMode::ACES)
    {
        return AcesReference(Rec709ToAces() * color);
    }
    if (mode == TonemappingMode::None)
    {
        return color;
    }
    const auto hable = [](double x)
    {
        return (x * (0.2 * x + 0.24 * 0.29) + 0.272 * 0.02) / (x * (0.2 * x + 0.29) + 0.272 * 0.3) -
               0.02 / 0.3;
    };
    glm::dvec3 result;
    for (int i = 0; i < 3; ++i)
    {
        result[i] = hable(color[i] / hable(5.3)) / hable(5.3);
    }
    return result;
}

/// @param isAcademy  in and out are ACES2065-1 and ACEScg, else Rec. 709 both
inline glm::dvec3 AdjustReference(glm::dvec3 color, const Adjustments& look, bool isAcademy)
{
    for (int i = 0; i < 3; ++i)
    {
        color[i] = LogarithmicContrast(color[i], 1.0 + look.contrast / 100.0, isAcademy);
    }
    const glm::dmat3 toAcesCg = glm::inverse(Ap1ToXyz()) * Ap0ToXyz();
    color = glm::max((isAcademy ? toAcesCg * color : color) * look.filter, 0.0);
    color = TurnedHue(color, look.hueShift);
    const double grey =
        isAcademy ? Luma(color) : glm::dot(color, glm::dvec3(0.2126729, 0.7151522, 0.0721750));
    return glm::max(glm::mix(glm::dvec3(grey), color, 1.0 + look.saturation / 100.0), 0.0);
}

inline glm::dvec3 GradeReference(const glm::dvec3& input, const Adjustments& look,
                                 ColorGradingMode grading, TonemappingMode tonemapping)
{
    glm::dvec3 color = input * std::exp2(look.exposure);
    if (grading == ColorGradingMode::LowDynamicRange)
    {
        color = glm::clamp(TonemapReference(color, tonemapping), 0.0, 1.0);
        return look.isNone() ? color : glm::clamp(AdjustReference(color, look, false), 0.0, 1.0);
    }
    const double end = (std::pow(10.0, (1.0 - 0.386036) / 0.244161) - 0.047996) / 5.555556;
    color = glm::min(color, end);
    const bool isAcademy = tonemapping == TonemappingMode::ACES;
    if (!look.isNone() && isAcademy)
    {
        const glm::dvec3 cg = AdjustReference(Rec709ToAces() * color, look, true);
        color = AcesReference(glm::inverse(Ap0ToXyz()) * Ap1ToXyz() * cg);
    }
    else
    {
        color = look.isNone() ? color : AdjustReference(color, look, false);
        color = TonemapReference(color, tonemapping);
    }
    return glm::clamp(color, 0.0, 1.0);
}

struct BloomLook
{
    double threshold = 0.9; ///< sRGB
    double intensity = 0.5;
    double scatter = 0.7;
    double clamp = 65472.0;
    glm::dvec3 tint{1.0}; ///< sRGB
    bool isHighQuality = false;
    bool quarter = false;
    int maxIterations = 6;

    void SetOn(Bloom& component) const
    {
        component.threshold.Override(static_cast<float>(threshold));
        component.intensity.Override(static_cast<float>(intensity));
        component.scatter.Override(static_cast<float>(scatter));
        component.clamp.Override(static_cast<float>(clamp));
        component.tint.Override({static_cast<float>(tint.x), static_cast<float>(tint.y),
                                 static_cast<float>(tint.z), 1.0f});
        component.highQualityFiltering.Override(isHighQuality);
        component.downscale.Override(quarter ? BloomDownscaleMode::Quarter
                                             : BloomDownscaleMode::Half);
        component.maxIterations.Override(maxIterations);
    }
};

/// A new picture of that size, of what a function gives at (u, v).
template <typename F>
Field PictureOf(const glm::ivec2& size, F&& function)
{
    Field black{size.x, size.y, 3,
                std::vector<double>(static_cast<std::size_t>(size.x) *
                                    static_cast<std::size_t>(size.y) * 3)};
    return PerPixel(black, [&](const glm::dvec3&, double u, double v) { return function(u, v); });
}

/// A cubic B-spline through the 4 x 4 texels around.
inline glm::dvec3 BicubicAt(const Field& field, double u, double v)
{
    const glm::dvec2 place(u * field.width - 0.5, v * field.height - 0.5);
    const glm::dvec2 base = glm::floor(place);
    const auto weight = [](double t)
    {
        const double a = std::abs(t);
        return a < 1 ? (4 - 6 * a * a + 3 * a * a * a) / 6 : a < 2 ? std::pow(2 - a, 3) / 6 : 0.0;
    };
    glm::dvec3 sum(0.0);
    for (int y = -1; y <= 2; ++y)
    {
        for (int x = -1; x <= 2; ++x)
        {
            const glm::dvec2 texel = base + glm::dvec2(x, y);
            sum += weight(place.x - texel.x) * weight(place.y - texel.y) *
                   At(field, (texel.x + 0.5) / field.width, (texel.y + 0.5) / field.height);
        }
    }
    return sum;
}

inline Field PrefilterReference(const Field& base, const BloomLook& look, const glm::ivec2& size)
{
    const double threshold = std::pow((look.threshold + 0.055) / 1.055, 2.4);
    const double knee = threshold / 2;
    // Jimenez 2014: weights of texels, or of places between them, around.
    const std::vector<std::pair<double, std::vector<glm::dvec2>>> taps = {
        {0.125, {{-0.5, -0.5}, {0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}, {0, 0}}},
        {0.0625, {{0, -1}, {-1, 0}, {1, 0}, {0, 1}}},
        {0.03125, {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}}};
    const auto bright = [&](double u, double v)
    {
        glm::dvec3 color = At(base, u, v);
        if (look.isHighQuality)
        {
            color = glm::dvec3(0.0);
            for (const auto& [weight, places] : taps)
            {
                for (const glm::dvec2& place : places)
                {
                    color += weight * At(base, u + place.x / base.width, v + place.y / base.height);
                }
            }
        }
        color = glm::min(color, look.clamp);
        const double brightness = std::max({color.x, color.y, color.z});
        double soft = std::clamp(brightness - threshold + knee, 0.0, 2 * knee);
        soft = soft * soft / (4 * knee + 1e-4);
        return color * std::max(brightness - threshold, soft) / std::max(brightness, 1e-4);
    };
    return PictureOf(size, bright);
}

/// Half the size, and a bell curve of nine texels along both axes.
inline Field BlurReference(const Field& source)
{
    const glm::ivec2 size =
        glm::max(glm::ivec2(source.width / 2, source.height / 2), glm::ivec2(1));
    const std::vector<double> weights = {0.22702703, 0.19459459, 0.12162162, 0.05405405,
                                         0.01621622};
    const auto along = [&](double u, double v)
    {
        glm::dvec3 sum(0.0);
        for (int i = -4; i <= 4; ++i)
        {
            sum += weights[static_cast<std::size_t>(std::abs(i))] *
                   At(source, u + 2.0 * i / source.width, v);
        }
        return sum;
    };
    const Field blurred = PictureOf(size, along);
    const auto down = [&](double u, double v)
    {
        glm::dvec3 sum(0.0);
        for (int i = -4; i <= 4; ++i)
        {
            sum += weights[static_cast<std::size_t>(std::abs(i))] *
                   At(blurred, u, v + 1.0 * i / blurred.height);
        }
        return sum;
    };
    return PictureOf(size, down);
}

inline glm::ivec2 LargestBloomMip(const Field& base, const BloomLook& look)
{
    const int part = look.quarter ? 4 : 2;
    return glm::max(glm::ivec2(base.width / part, base.height / part), glm::ivec2(1));
}

inline int BloomMipCount(const Field& base, const BloomLook& look)
{
    const glm::ivec2 largest = LargestBloomMip(base, look);
    const double halvings = std::floor(std::log2(std::max(largest.x, largest.y)) - 1.0);
    return std::clamp(static_cast<int>(halvings), 1, look.maxIterations);
}

/// What is added to the picture.
inline Field BloomReference(const Field& base, const BloomLook& look)
{
    const int count = BloomMipCount(base, look);
    std::vector<Field> mips = {PrefilterReference(base, look, LargestBloomMip(base, look))};
    for (int i = 1; i < count; ++i)
    {
        mips.push_back(BlurReference(mips.back()));
    }
    Field sum = mips.back();
    const auto enlarged = [&](double u, double v)
    {
        return look.isHighQuality ? BicubicAt(sum, u, v) : At(sum, u, v);
    };
    for (int i = count - 2; i >= 0; --i)
    {
        const Field& high = mips[static_cast<std::size_t>(i)];
        sum = PictureOf(
            {high.width, high.height}, [&](double u, double v)
            { return glm::mix(At(high, u, v), enlarged(u, v), 0.05 + 0.9 * look.scatter); });
    }
    glm::dvec3 tint;
    for (int i = 0; i < 3; ++i)
    {
        tint[i] = std::pow((look.tint[i] + 0.055) / 1.055, 2.4);
    }
    tint /= glm::dot(tint, glm::dvec3(0.2126729, 0.7151522, 0.0721750));
    return PictureOf({base.width, base.height},
                     [&](double u, double v) { return look.intensity * tint * enlarged(u, v); });
}

} // namespace limn::test
