#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limn/core/GraphicsFormat.h>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// Texels on the CPU: `height` rows of `width` texels, row 0 at the top, tightly packed.
struct Image
{
    int width = 0;
    int height = 0;
    GraphicsFormat format = GraphicsFormat::None;
    std::vector<std::byte> texels;

    bool operator==(const Image&) const = default;
};

/// Returns the same texels with the last of `rows` rows first. This turns an Image's texels into
/// those that a Texture2D takes, and back.
/// @throws ContractError if the bytes are no whole number of rows
std::vector<std::byte> FlipRows(std::span<const std::byte> texels, int rows);

/// Returns an R8G8B8A8 (SRGB or UNorm) or R8_UNorm image as the bytes of a PNG file.
/// @throws ContractError for any other format, or if size and texels do not fit each other
/// @throws AssetError if the image is too large for a PNG
std::vector<std::byte> EncodePng(const Image& image);

/// Writes the bytes of EncodePng as WriteFile does: the file appears whole or not at all, and a
/// file that was there before stays if writing fails.
/// @throws AssetError naming the path and the system's reason, if it cannot be written
/// @throws ContractError as EncodePng
void WritePng(const std::filesystem::path& path, const Image& image);

/// Reads a PNG of any kind as R8G8B8A8_SRGB, of at most 16384 texels in width and height. It takes
/// no more memory than a file of that length can fill.
/// @throws AssetError if the file is missing or is no PNG
Image ReadPng(const std::filesystem::path& path);

/// Decodes the bytes of a PNG file as ReadPng does.
/// @param name  the name of the file in errors
/// @throws AssetError if the bytes are no PNG
Image DecodePng(std::string_view bytes, const std::string& name);

/// Returns the bytes of the texels that ReadPng would return, according to the file's header; 0 for
/// a file without such a header.
std::uintmax_t PngTexelBytes(const std::filesystem::path& path);

} // namespace limn
