#include "report/truth/twins/Field.h"

#include <algorithm>
#include <cmath>

namespace limn::study
{

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

} // namespace limn::study
