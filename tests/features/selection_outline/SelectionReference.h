#pragma once

#include "features/OutlineGpuReference.h"
#include "report/truth/twins/Twins.h"

namespace limn::test
{

using study::BlurReference;

/// The article's stencil colour at so many seconds, of an object selected at others, as an 8-bit
/// texture stores it.
inline std::array<double, 4> StencilColorReference(double time, double start)
{
    const double s = std::sin(2.0 * time - 2.0 * start);
    const double c = std::cos(2.0 * time - 2.0 * start);
    std::array<double, 4> color{s + 1.0, c + 1.0, 1.0 - s, 1.0 - c};
    for (double& component : color)
    {
        component = std::round(std::clamp(component, 0.0, 1.0) * 255.0) / 255.0;
    }
    return color;
}

/// All blurs of the image effect, rounded to 8 bits behind each. The mean of four 8-bit numbers is
/// half way between two such as often as not, and float decides which it becomes.
/// @param tie  1: the higher one, -1: the lower one; what is drawn lies in between
inline Field BlurredReference(Field stencil, double offset, int iterate, int tie)
{
    const auto quantise = [tie](double value)
    {
        constexpr double k_Noise = 1e-4; // of float, in units of 1/255
        return std::floor(value * 255.0 + 0.5 + tie * k_Noise) / 255.0;
    };
    for (int i = 0; i < 2 * iterate + 1; ++i)
    {
        stencil = BlurReference(stencil, offset);
        std::ranges::transform(stencil.values, stencil.values.begin(), quantise);
    }
    return stencil;
}

/// How far a field is from what lies between two others, in units of 1/255.
struct Outside
{
    double largest = 0.0;
    double shareWithinTwo = 1.0; ///< of all channel values
};

inline Outside CompareBetween(const Field& drawn, const Field& a, const Field& b)
{
    Outside result;
    std::size_t within = 0;
    for (std::size_t i = 0; i < drawn.values.size(); ++i)
    {
        const auto [low, high] = std::minmax(a.values.at(i), b.values.at(i));
        const double distance =
            std::max({low - drawn.values[i], drawn.values[i] - high, 0.0}) * 255.0;
        result.largest = std::max(result.largest, distance);
        within += distance <= 2.0 ? 1 : 0;
    }
    result.shareWithinTwo = static_cast<double>(within) / static_cast<double>(drawn.values.size());
    return result;
}

} // namespace limn::test
