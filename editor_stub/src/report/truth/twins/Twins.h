#pragma once

#include "report/truth/OutlineReference.h"

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

/// Returns true if the technique draws the objects and takes the edges from that drawing, where the
/// device has rounded their corners; false if it takes the edges from the mesh.
bool DrawsItsEdges(const std::string& technique);

} // namespace limn::study
