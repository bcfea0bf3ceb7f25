#pragma once

#include <filesystem>
#include <limn/core/Image.h>

namespace limn
{

/// Returns whether limn reads pictures with this ending: ".png", ".tif", ".jpg" and the like.
bool IsPictureFile(const std::filesystem::path& path);

/// A picture of 8 bits a channel as R8G8B8A8_SRGB: PNG, TIFF, and JPEG, TGA, BMP and PSD of one
/// layer. A fourth channel is alpha, whatever the file calls it, as Unity takes it; more precise
/// numbers are rounded.
/// @throws AssetError  if the file is missing or none of these, or has more than 16384 texels
/// either
///     way
Image ReadPicture(const std::filesystem::path& path);

} // namespace limn
