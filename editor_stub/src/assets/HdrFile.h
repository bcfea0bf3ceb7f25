#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limn/core/Image.h>
#include <string_view>

namespace limn
{

/// Radiance HDR, packed or not, the top row first, as R16G16B16A16_SFloat. Not by stb_image, which
/// goes on for ever where a packed file is cut off.
/// @param requireSize  throws for sizes that are not read, before memory is taken for them
/// @throws AssetError  if it is broken, or of a kind that is hardly ever written: XYZ colours,
/// other
///     orders of rows, the packing of before 1991
Image DecodeHdr(const std::filesystem::path& path, std::string_view bytes,
                const std::function<void(std::uint32_t width, std::uint32_t height)>& requireSize);

} // namespace limn
