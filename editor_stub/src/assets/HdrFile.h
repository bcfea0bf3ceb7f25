#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limn/core/Image.h>
#include <string_view>

namespace limn
{

/// Decodes a Radiance HDR file, packed or not, into R16G16B16A16_SFloat, the top row first.
/// stb_image is not used, since it goes on for ever where a packed file is cut off.
/// @param requireSize  throws for sizes that limn does not read, before memory is taken for them
/// @throws AssetError  if the file is broken, or of a kind that is hardly ever written: XYZ
///     colours, other orders of rows, the packing of before 1991
Image DecodeHdr(const std::filesystem::path& path, std::string_view bytes,
                const std::function<void(std::uint32_t width, std::uint32_t height)>& requireSize);

/// Decodes the first part of an OpenEXR file into R16G16B16A16_SFloat: RGB, RGBA, or grey in a
/// channel Y.
/// @param requireSize  throws for sizes that limn does not read, before memory is taken for them
/// @throws AssetError  if the file is broken
Image DecodeExr(const std::filesystem::path& path, std::string_view bytes,
                const std::function<void(std::uint32_t width, std::uint32_t height)>& requireSize);

/// Returns the nearest finite number of 16 bits, or 0 for a NaN.
std::uint16_t HalfOf(float value);

} // namespace limn
