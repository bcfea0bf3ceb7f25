#pragma once

#include <filesystem>
#include <limn/core/Image.h>
#include <string_view>

namespace limn
{

/// Returns whether limn reads pictures with this ending: ".png", ".tif", ".exr" and the like.
bool IsPictureFile(const std::filesystem::path& path);

/// A picture, the top row first: PNG, TIFF, and JPEG, TGA, BMP and PSD of one layer as
/// R8G8B8A8_SRGB, more precise numbers rounded; OpenEXR and Radiance HDR, which are linear, as
/// R16G16B16A16_SFloat, what is no number as 0 and what is too large as the largest. A fourth
/// channel is alpha, whatever the file calls it, as Unity takes it.
/// @param path   its ending tells the kind; what errors call it
/// @param bytes  of the file
/// @throws AssetError  if it is none of these, or has more than 16384 texels either way, or more
///     than a file of that length can hold
Image DecodePicture(const std::filesystem::path& path, std::string_view bytes);

} // namespace limn
