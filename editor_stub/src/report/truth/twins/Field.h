#pragma once

#include <array>
#include <limn/core/Image.h>
#include <vector>

namespace limn::study
{

/// An image of doubles, row 0 at the top, `channels` values a texel.
struct Field
{
    int width = 0;
    int height = 0;
    int channels = 1;
    std::vector<double> values;

    double& At(int x, int y, int channel = 0);
    double At(int x, int y, int channel = 0) const;
    /// Bilinear, clamped at the border; u, v in 0...1, (0, 0) the top left corner.
    double Sample(double u, double v, int channel = 0) const;
};

/// The texels of an R8_UNorm, R8G8B8A8 or R16G16B16A16_SFloat image as numbers, no sRGB decoding.
Field ToField(const Image& image);

/// The article's second pass in double precision: Roberts cross of a mask with bilinear taps.
/// @param width  of the outline, pixels of the full-size picture
Field RobertsReference(const Field& mask, double width);

/// Values as an 8-bit texture stores them: clamped to 0...1 and rounded to n/255.
Field QuantiseToR8(const Field& field);

/// The article's third pass: base.rgb + edge * colour, alpha of the base.
/// @param color  linear
Field CompositeReference(const Field& base, const Field& edge, const std::array<double, 3>& color);

/// How far two fields are apart, in units of 1/255.
struct Difference
{
    double largest = 0.0;
    double shareWithinOne = 1.0; ///< of all channel values
};
Difference Compare(const Field& a, const Field& b);

} // namespace limn::study
