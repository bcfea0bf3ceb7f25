#pragma once

#include <array>
#include <vector>

namespace limn::study
{

/// An image of doubles with `channels` values for each texel. Row 0 is at the top.
struct Field
{
    int width = 0;
    int height = 0;
    int channels = 1;
    std::vector<double> values;

    double& At(int x, int y, int channel = 0);
    double At(int x, int y, int channel = 0) const;
    /// Returns a bilinear sample, clamped at the border. u and v are in 0...1; (0, 0) is the top
    /// left corner.
    double Sample(double u, double v, int channel = 0) const;
};

/// Returns the result of the article's second pass in double precision: Roberts cross of a mask
/// with bilinear taps.
/// @param width  the outline's width, in pixels of the full-size picture
Field RobertsReference(const Field& mask, double width);

/// Returns the result of the article's third pass: base.rgb + edge * colour, with the alpha of the
/// base.
/// @param color  the colour, linear
Field CompositeReference(const Field& base, const Field& edge, const std::array<double, 3>& color);

/// Returns the result of the article's blur: the largest colour and the mean alpha of four bilinear
/// taps.
/// @param offset  the offset of the taps in texels, along both axes
Field BlurReference(const Field& source, double offset);

/// Returns the article's composite of a picture with four channels.
Field CompositeReference(const Field& source, const Field& stencil, const Field& blur,
                         double strength);

} // namespace limn::study
