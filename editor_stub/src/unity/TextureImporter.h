#pragma once

#include "assets/Importer.h"

#include <filesystem>
#include <limn/core/Texture.h>
#include <memory>

namespace limn
{

/// Returns the file in which Unity keeps a texture's import settings: "wood.png.meta".
std::filesystem::path MetaFileOf(const std::filesystem::path& texture);

/// Imports a picture, upright on a mesh, as the TextureImporter of its .meta file says: mip maps,
/// sRGB, size, channels, normals, filter, wrap modes, anisotropy and mip bias. Missing settings,
/// and all settings without such an importer, are Unity's defaults: sRGB with mip maps, bilinear,
/// repeated. With an importer the default size is at most 2048 texels either way. Compression,
/// alphaIsTransparency and sizes that are no powers of two change nothing.
/// @throws AssetError as DecodePicture, and with every wrong value of the .meta file
std::shared_ptr<const Texture2D> ImportTexture(const std::filesystem::path& path,
                                               const Importer& importer = Importer());

/// Imports a picture as a cube, if its .meta file says that it is one: a cross or a strip of six
/// faces, or a picture of longitude and latitude. All else is as in ImportTexture.
/// @return null if the .meta file does not say so, or is missing
/// @throws AssetError as ImportTexture, also if there is no file, and for the picture of a
/// mirroring
///     ball
std::shared_ptr<const Cubemap> ImportCubemap(const std::filesystem::path& path,
                                             const Importer& importer = Importer());

} // namespace limn
