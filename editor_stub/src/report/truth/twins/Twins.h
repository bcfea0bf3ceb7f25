#pragma once

#include "report/truth/OutlineReference.h"

#include <array>
#include <functional>
#include <string>

namespace limn::study
{

/// A technique's own arithmetic in double precision, for a white outline on black. The result is
/// not the true outline, but what the technique would draw if nothing were rounded. Textures hold
/// doubles. Samples are where the rasteriser has them, at pixel centres or at Vulkan's four places.
/// A device's picture differs by rounding, by formats of few bits, and where an edge is closer to a
/// sample than the part of a pixel to which vertices are placed.
using Twin =
    std::function<Coverage(const Silhouette&, double width, int pictureWidth, int pictureHeight)>;

/// @param technique  Technique::name
/// @return an empty function if nothing repeats the technique's arithmetic
Twin FindTwin(const std::string& technique);

// The passes of the articles in double precision.

using Field = Coverage; ///< as the texture that a pass reads or draws, with 1 to 4 channels

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
