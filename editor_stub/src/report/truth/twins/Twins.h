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

/// The first article's: mask of half the size, Roberts cross, bilinear composite.
Coverage ScreenSpaceTwin(const Silhouette& silhouette, double width, int pictureWidth,
                         int pictureHeight);
/// The article on selection: seven blurs of the mask. The device keeps 8 bits behind each, and a
/// mean of four such numbers is half way between two as often as not.
Coverage SelectionTwin(const Silhouette& silhouette, double width, int pictureWidth,
                       int pictureHeight);
/// The article on post-processing: where the mask differs from four texels around.
Coverage MaskDifferenceTwin(const Silhouette& silhouette, double width, int pictureWidth,
                            int pictureHeight);
/// The distance to the places on the edge of a mask of four samples.
/// @param isFlood  by jump flooding, else by columns and then rows
Coverage WideTwin(const Silhouette& silhouette, double width, int pictureWidth, int pictureHeight,
                  bool isFlood);
/// Strokes along the silhouette, which may have no edges inside.
Coverage StrokeTwin(const Silhouette& silhouette, double width, int pictureWidth,
                    int pictureHeight);

/// The part of a square of side 1 that is behind a straight edge: BoxCoverage.hlsl.
/// @param normal  of the edge, unit length
/// @param depth   how far the square's centre is behind it
double BoxCoverage(const glm::dvec2& normal, double depth);
/// The depth for which BoxCoverage gives that.
double BoxDepth(const glm::dvec2& normal, double coverage);

} // namespace limn::study
