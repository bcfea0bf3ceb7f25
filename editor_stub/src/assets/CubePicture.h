#pragma once

#include <cstdint>
#include <limn/core/Image.h>
#include <optional>

namespace limn
{

/// The way in which one picture shows what is all around.
/// Unity: UnityEditor.TextureImporterGenerateCubemap (2022.3).
enum class CubeMapping : std::uint8_t
{
    None = 0,        ///< it does not
    Spheremap = 1,   ///< a mirroring ball
    Cylindrical = 2, ///< longitude and latitude; +Z is in the middle, and +X right of it
    FullCubemap = 5, ///< six squares: a cross, or a strip +X -X +Y -Y +Z -Z
    AutoCubemap = 6  ///< the one whose shape is nearest to the picture's
};

/// Returns how many faces lie along the longer side of a picture, for limits on a face's size: four
/// along a circle of latitude.
int FacesAlong(const Image& picture, CubeMapping mapping);

/// Returns the six faces below each other, in the order and as upright as CubemapFaces holds them.
/// A picture of longitude and latitude is filtered linearly, a face having a quarter of its width;
/// of the others the squares are cut out.
/// @param picture  R8G8B8A8 or R16G16B16A16_SFloat; filtered in linear light if it is sRGB
/// @return nullopt if the picture shows a mirroring ball, which limn does not read, or is too small
///     to have six faces
std::optional<Image> CutCube(Image picture, CubeMapping mapping);

} // namespace limn
