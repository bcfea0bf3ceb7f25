#pragma once

#include "assets/Importer.h"

#include <filesystem>
#include <limn/core/Texture.h>
#include <memory>

namespace limn
{

/// The file in which Unity keeps how a texture is imported: "wood.png.meta".
std::filesystem::path MetaFileOf(const std::filesystem::path& texture);

/// A picture, upright on a mesh, as the TextureImporter of its .meta file says: mip maps, sRGB,
/// size, channels, normals, filter, wrap modes, anisotropy and mip bias. Without one, or where it
/// does not say, Unity's defaults: sRGB with mip maps, bilinear, repeated, of at most 2048 texels
/// either way where there is an importer. Compression, alphaIsTransparency and sizes that are no
/// powers of two change nothing.
/// @throws AssetError as DecodePicture, and with every wrong value of the .meta file
std::shared_ptr<const Texture2D> ImportTexture(const std::filesystem::path& path,
                                               const Importer& importer = Importer());

} // namespace limn
