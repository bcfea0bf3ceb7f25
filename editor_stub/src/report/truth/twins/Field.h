#pragma once

#include "report/truth/OutlineReference.h"

namespace limn::study
{

using Field = Coverage;

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

/// Returns the article's composite. The stencil and the blur have four channels.
Field CompositeReference(const Field& source, const Field& stencil, const Field& blur,
                         double strength);

} // namespace limn::study
