#include "report/truth/twins/Field.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <stdexcept>

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

Field ToField(const Image& image)
{
    Field field{image.width, image.height, 1, {}};
    if (image.format == GraphicsFormat::R16G16B16A16_SFloat)
    {
        field.channels = 4;
        for (std::size_t i = 0; i + 1 < image.texels.size(); i += 2)
        {
            std::uint16_t half = 0;
            std::memcpy(&half, image.texels.data() + i, 2);
            field.values.push_back(glm::unpackHalf1x16(half));
        }
        return field;
    }
    if (image.format != GraphicsFormat::R8_UNorm && BytesPerTexel(image.format) != 4)
    {
        throw std::invalid_argument("ToField knows R8_UNorm, R8G8B8A8 and R16G16B16A16_SFloat");
    }
    field.channels = BytesPerTexel(image.format);
    for (const std::byte texel : image.texels)
    {
        field.values.push_back(std::to_integer<int>(texel) / 255.0);
    }
    return field;
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

Field QuantiseToR8(const Field& field)
{
    Field result = field;
    for (double& value : result.values)
    {
        value = std::round(std::clamp(value, 0.0, 1.0) * 255.0) / 255.0;
    }
    return result;
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

Difference Compare(const Field& a, const Field& b)
{
    if (a.values.size() != b.values.size() || a.values.empty())
    {
        throw std::invalid_argument("Compare: the fields have different sizes or none");
    }
    Difference difference;
    std::size_t withinOne = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
    {
        const double distance = std::abs(a.values[i] - b.values[i]) * 255.0;
        difference.largest = std::max(difference.largest, distance);
        withinOne += distance <= 1.0 ? 1 : 0;
    }
    difference.shareWithinOne =
        static_cast<double>(withinOne) / static_cast<double>(a.values.size());
    return difference;
}

} // namespace limn::study
