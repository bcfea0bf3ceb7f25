#pragma once

#include <filesystem>
#include <limn/core/Texture.h>
#include <memory>

namespace limn
{

/// The file in which Unity keeps how a texture is imported: "wood.png.meta".
std::filesystem::path MetaFileOf(const std::filesystem::path& texture);

/// A PNG file, upright on a mesh, as the TextureImporter of its .meta file says: mip maps, sRGB,
/// filter, wrap modes, anisotropy and mip bias. Without one, or where it does not say, Unity's
/// defaults: sRGB with mip maps, bilinear, repeated.
/// @throws AssetError as ReadPng, and with every wrong value of the .meta file
std::shared_ptr<const Texture2D> ImportTexture(const std::filesystem::path& path);

} // namespace limn
