#pragma once

#include <limn/core/Texture.h>
#include <memory>

namespace limn
{

/// The side of BlueNoise(), in texels.
inline constexpr int k_BlueNoiseSize = 48;

/// Returns a texture that has each of 0...255 nine times, with equal values far apart, and the same
/// in all channels. It repeats without a seam. It is made once in a process, which takes about 25
/// ms.
/// @source Ulichney, "The void-and-cluster method for dither array generation", 1993
const std::shared_ptr<const Texture2D>& BlueNoise();

} // namespace limn
