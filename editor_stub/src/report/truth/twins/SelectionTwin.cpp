#include "report/truth/twins/SelectionTwin.h"

#include <algorithm>
#include <cmath>

namespace limn::study
{

std::array<double, 4> StencilColorReference(double time, double start)
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

Field BlurReference(const Field& source, double offset)
{
    Field result = source;
    const double du = offset / source.width;
    const double dv = offset / source.height;
    for (int y = 0; y < source.height; ++y)
    {
        for (int x = 0; x < source.width; ++x)
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
        }
    }
    return result;
}

Field BlurredReference(Field stencil, double offset, int iterate, int tie)
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

Field CompositeReference(const Field& source, const Field& stencil, const Field& blur,
                         double strength)
{
    Field result = source;
    for (int y = 0; y < source.height; ++y)
    {
        for (int x = 0; x < source.width; ++x)
        {
            const bool isInside = stencil.At(x, y, 0) != 0.0 || stencil.At(x, y, 1) != 0.0 ||
                                  stencil.At(x, y, 2) != 0.0;
            const double weight =
                isInside ? 0.0 : std::clamp(blur.At(x, y, 3) - stencil.At(x, y, 3), 0.0, 1.0);
            for (int channel = 0; channel < 3; ++channel)
            {
                double& value = result.At(x, y, channel);
                value += weight * (blur.At(x, y, channel) * strength - value);
            }
        }
    }
    return result;
}

Outside CompareBetween(const Field& drawn, const Field& a, const Field& b)
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

} // namespace limn::study
