#pragma once

#include "report/truth/twins/Twins.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <limn/core/Image.h>
#include <stdexcept>

namespace limn::test
{

using study::CompositeReference;
using study::Field;
using study::RobertsReference;

/// The texels of an R8_UNorm, R8G8B8A8 or R16G16B16A16_SFloat image as numbers, no sRGB decoding.
inline Field ToField(const Image& image)
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

/// Values as an 8-bit texture stores them: clamped to 0...1 and rounded to n/255.
inline Field QuantiseToR8(const Field& field)
{
    Field result = field;
    for (double& value : result.values)
    {
        value = std::round(std::clamp(value, 0.0, 1.0) * 255.0) / 255.0;
    }
    return result;
}

/// How far two fields are apart, in units of 1/255.
struct Difference
{
    double largest = 0.0;
    double shareWithinOne = 1.0; ///< of all channel values
};

inline Difference Compare(const Field& a, const Field& b)
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

} // namespace limn::test
