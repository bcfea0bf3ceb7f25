#pragma once

#include <cstddef>
#include <limn/core/Image.h>
#include <span>
#include <vector>

namespace limn
{

/// Returns the components of a texel as shaders see them, red first: linear, integers as they are.
/// Depth is one component.
/// @param texel  BytesPerTexel(format) bytes
std::vector<float> TexelValue(std::span<const std::byte> texel, GraphicsFormat format);

/// Returns the bytes of one texel.
/// @param x, y  from the top left
std::vector<std::byte> TexelAt(const Image& image, int x, int y);

} // namespace limn
