#pragma once

#include <array>
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

/// The article's second pass in double precision: Roberts cross of a mask with bilinear taps.
/// @param width  of the outline, pixels of the full-size picture
Field RobertsReference(const Field& mask, double width);

/// The article's third pass: base.rgb + edge * colour, alpha of the base.
/// @param color  linear
Field CompositeReference(const Field& base, const Field& edge, const std::array<double, 3>& color);

/// The article's blur: the largest colour and the mean alpha of four bilinear taps.
/// @param offset  texels along both axes
Field BlurReference(const Field& source, double offset);

/// The article's composite of a picture of four channels.
Field CompositeReference(const Field& source, const Field& stencil, const Field& blur,
                         double strength);

} // namespace limn::study
