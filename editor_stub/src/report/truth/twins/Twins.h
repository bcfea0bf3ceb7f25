#pragma once

#include "report/truth/OutlineReference.h"

#include <functional>
#include <string>

namespace limn::study
{

/// A technique's own arithmetic in double precision, of a white outline on black: not what an
/// outline is in truth, but what the technique would draw if nothing was rounded. Textures hold
/// doubles; samples lie where the rasteriser has them, at pixel centres or at Vulkan's four places.
/// What a device draws differs by rounding, by formats of few bits, and where an edge passes a
/// sample nearer than the part of a pixel to which vertices are placed.
using Twin =
    std::function<Coverage(const Silhouette&, double width, int pictureWidth, int pictureHeight)>;

/// @param technique  Technique::name
/// @return empty where nothing repeats the technique's arithmetic
Twin FindTwin(const std::string& technique);

/// Returns true if the technique draws the objects and takes the edges from that drawing, where the
/// device has rounded their corners; false if it takes the edges from the mesh.
bool DrawsItsEdges(const std::string& technique);

} // namespace limn::study
