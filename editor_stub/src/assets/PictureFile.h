#pragma once

#include <filesystem>
#include <limn/core/Image.h>
#include <string_view>

namespace limn
{

/// Returns whether limn reads pictures with this ending: ".png", ".tif", ".exr" and the like.
bool IsPictureFile(const std::filesystem::path& path);

/// Decodes a picture, the top row first. PNG, TIFF, and JPEG, TGA, BMP and PSD of one layer become
/// R8G8B8A8_SRGB; more precise numbers are rounded. OpenEXR and Radiance HDR, which are linear,
/// become R16G16B16A16_SFloat; a NaN becomes 0, and a number that is too large becomes the largest.
/// A fourth channel is alpha, whatever the file calls it, as Unity takes it.
/// @param path   the file's path, whose ending tells the kind; errors name it
/// @param bytes  the file's content
/// @throws AssetError  if the file is none of these, or has more than 16384 texels either way, or
///     more than a file of that length can hold
Image DecodePicture(const std::filesystem::path& path, std::string_view bytes);

} // namespace limn
