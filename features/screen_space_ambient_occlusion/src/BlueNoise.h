#pragma once

#include <limn/core/Texture.h>
#include <memory>

namespace limn
{

/// The side of BlueNoise(), texels.
inline constexpr int k_BlueNoiseSize = 64;

/// Returns a texture whose texels have each of 4096 values once, spread over 0...255, so that those
/// beside each other are far apart; the same in all channels. It repeats without a seam.
/// Made once, in a few milliseconds.
/// @source Ulichney, "The void-and-cluster method for dither array generation", 1993
const std::shared_ptr<const Texture2D>& BlueNoise();

} // namespace limn
