#include "report/truth/twins/Field.h"

#include <algorithm>
#include <cmath>

namespace limn::study
{

double& Field::At(int x, int y, int channel)
{
    return values.at(static_cast<std::size_t>((y * width + x) * channels + channel));
}

double Field::At(int x, int y, int channel) const
{
    return values.at(static_cast<std::size_t>((y * width + x) * channels + channel));
}

double Field::Sample(double u, double v, int channel) const
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

Field RobertsReference(const Field& mask, double width)
{
    Field edge{mask.width, mask.height, 1, {}};
    edge.values.resize(mask.values.size());
    const double lower = std::floor(width * 0.5) * 0.5 / mask.width;
    const double upper = std::ceil(width * 0.5) * 0.5 / mask.width;
    const double lowerV = std::floor(width * 0.5) * 0.5 / mask.height;
    const double upperV = std::ceil(width * 0.5) * 0.5 / mask.height;
    for (int y = 0; y < mask.height; ++y)
    {
        for (int x = 0; x < mask.width; ++x)
        {
            const double u = (x + 0.5) / mask.width;
            const double v = (y + 0.5) / mask.height;
            const double tap0 = mask.Sample(u - lower, v + upperV);
            const double tap1 = mask.Sample(u + upper, v + lowerV);
            const double tap2 = mask.Sample(u - lower, v - upperV);
            const double tap3 = mask.Sample(u + upper, v - lowerV);
            edge.At(x, y) = std::hypot(tap1 - tap2, tap0 - tap3);
        }
    }
    return edge;
}

Field CompositeReference(const Field& base, const Field& edge, const std::array<double, 3>& color)
{
    Field result = base;
    for (int y = 0; y < base.height; ++y)
    {
        for (int x = 0; x < base.width; ++x)
        {
            const double amount = edge.Sample((x + 0.5) / base.width, (y + 0.5) / base.height);
            for (int channel = 0; channel < 3; ++channel)
            {
                result.At(x, y, channel) += amount * color[static_cast<std::size_t>(channel)];
            }
        }
    }
    return result;
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

} // namespace limn::study
