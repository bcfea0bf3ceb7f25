#include "assets/PictureFile.h"

#include "assets/HdrFile.h"
#include "console/Texts.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <limn/base/Case.h>
#include <limn/base/Diagnostic.h>
#include <memory>
#include <tiffio.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_NO_PNG
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_NO_GIF
#define STBI_NO_PIC
#define STBI_NO_PNM
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace limn
{

namespace
{

constexpr int k_MostTexels = 16384;

[[noreturn]] void Fail(const std::filesystem::path& path, const std::string& message)
{
    throw AssetError(path.generic_string(), {}, message);
}

/// Memory is taken by what a file can hold, not by what it says. No packing that is read makes more
/// texels of a byte, but for a single colour.
void RequireSize(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                 std::size_t fileBytes)
{
    constexpr std::uint64_t k_AnyFile = std::uint64_t{1} << 20;
    constexpr std::uint64_t k_TexelsOfAByte = 8192;
    if (width == 0 || height == 0 || width > k_MostTexels || height > k_MostTexels)
    {
        Fail(path, "the picture has " + std::to_string(width) + "x" + std::to_string(height) +
                       " texels; limn reads 1 to " + std::to_string(k_MostTexels) + " either way");
    }
    if (std::uint64_t{width} * height > std::max(k_AnyFile, k_TexelsOfAByte * fileBytes))
    {
        Fail(path, "a file of " + std::to_string(fileBytes) + " bytes cannot hold a picture of " +
                       std::to_string(width) + "x" + std::to_string(height) + " texels");
    }
}

/// A file in memory, as libtiff reads one.
struct TiffBytes
{
    std::string_view bytes;
    std::size_t at = 0;

    static tmsize_t Read(thandle_t handle, void* target, tmsize_t size)
    {
        auto& file = *static_cast<TiffBytes*>(handle);
        const std::size_t count =
            std::min(static_cast<std::size_t>(size), file.bytes.size() - file.at);
        std::memcpy(target, file.bytes.data() + file.at, count);
        file.at += count;
        return static_cast<tmsize_t>(count);
    }
    static tmsize_t Write(thandle_t, void*, tmsize_t) { return 0; }
    static toff_t Seek(thandle_t handle, toff_t offset, int from)
    {
        auto& file = *static_cast<TiffBytes*>(handle);
        const toff_t base = from == SEEK_SET ? 0 : from == SEEK_CUR ? file.at : file.bytes.size();
        file.at = static_cast<std::size_t>(std::min<toff_t>(base + offset, file.bytes.size()));
        return file.at;
    }
    static int Close(thandle_t) { return 0; }
    static toff_t Size(thandle_t handle) { return static_cast<TiffBytes*>(handle)->bytes.size(); }
};

/// Channel `channel` of a texel, from 0 to 255.
std::byte TiffSample(const std::byte* row, std::size_t index, int bits)
{
    if (bits == 16)
    {
        std::uint16_t value = 0;
        std::memcpy(&value, row + 2 * index, sizeof value);
        return static_cast<std::byte>((value * 255u + 32767u) / 65535u);
    }
    return row[index];
}

Image ReadTiff(const std::filesystem::path& path, std::string_view bytes)
{
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
    TiffBytes file{bytes};
    const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(
        TIFFClientOpen("picture", "rm", &file, TiffBytes::Read, TiffBytes::Write, TiffBytes::Seek,
                       TiffBytes::Close, TiffBytes::Size, nullptr, nullptr),
        TIFFClose);
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    if (!tiff || TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width) == 0 ||
        TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height) == 0)
    {
        Fail(path, "this is no TIFF file, or a broken one");
    }
    RequireSize(path, width, height, bytes.size());
    std::uint16_t channels = 1;
    std::uint16_t bits = 1;
    std::uint16_t layout = PLANARCONFIG_CONTIG;
    std::uint16_t meaning = PHOTOMETRIC_MINISBLACK;
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, &channels);
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_BITSPERSAMPLE, &bits);
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_PLANARCONFIG, &layout);
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_PHOTOMETRIC, &meaning);
    const bool isRead = (bits == 8 || bits == 16) && layout == PLANARCONFIG_CONTIG &&
                        (meaning == PHOTOMETRIC_RGB || meaning == PHOTOMETRIC_MINISBLACK) &&
                        channels >= (meaning == PHOTOMETRIC_RGB ? 3 : 1) &&
                        TIFFIsTiled(tiff.get()) == 0;
    const auto rowBytes = static_cast<std::size_t>(TIFFScanlineSize(tiff.get()));
    if (!isRead || rowBytes < std::size_t{width} * channels * bits / 8)
    {
        Fail(path, "limn does not read this kind of TIFF file; save it in rows, with 8 or 16 bits "
                   "per channel, as grey or RGB, with or without alpha");
    }
    Image image{static_cast<int>(width), static_cast<int>(height), GraphicsFormat::R8G8B8A8_SRGB,
                std::vector<std::byte>(std::size_t{width} * height * 4, std::byte{255})};
    std::vector<std::byte> row(rowBytes);
    const bool isGrey = meaning == PHOTOMETRIC_MINISBLACK;
    const std::size_t alpha = isGrey ? 1 : 3;
    for (std::uint32_t y = 0; y < height; ++y)
    {
        if (TIFFReadScanline(tiff.get(), row.data(), y, 0) < 0)
        {
            Fail(path, "the TIFF file ends before its picture does, or is broken");
        }
        std::byte* target = image.texels.data() + std::size_t{y} * width * 4;
        for (std::uint32_t x = 0; x < width; ++x, target += 4)
        {
            const std::size_t first = std::size_t{x} * channels;
            for (std::size_t c = 0; c < 3; ++c)
            {
                target[c] = TiffSample(row.data(), first + (isGrey ? 0 : c), bits);
            }
            if (channels > alpha)
            {
                target[3] = TiffSample(row.data(), first + alpha, bits);
            }
        }
    }
    return image;
}

/// Returns the usual ending of the format that the first bytes tell, since public projects have
/// files with the name of another format. TGA has no such bytes; then the name decides.
std::string FormatOf(const std::filesystem::path& path, std::string_view bytes)
{
    using namespace std::string_view_literals;
    for (const auto& [magic, ending] :
         {std::pair("\x89PNG"sv, ".png"), std::pair("II*\0"sv, ".tif"),
          std::pair("MM\0*"sv, ".tif"), std::pair("\x76\x2f\x31\x01"sv, ".exr"),
          std::pair("#?"sv, ".hdr"), std::pair("\xff\xd8\xff"sv, ".jpg"),
          std::pair("8BPS"sv, ".psd"), std::pair("BM"sv, ".bmp")})
    {
        if (bytes.starts_with(magic))
        {
            return ending;
        }
    }
    return ToLower(path.extension().string());
}

Image ReadByStb(const std::filesystem::path& path, std::string_view bytes)
{
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0)
    {
        Fail(path, "this is no picture that limn reads, or a broken one");
    }
    RequireSize(path, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
                bytes.size());
    const std::unique_ptr<stbi_uc, void (*)(void*)> texels(
        stbi_load_from_memory(data, size, &width, &height, &channels, 4), stbi_image_free);
    if (!texels)
    {
        Fail(path, std::string("the picture is broken: ") + stbi_failure_reason());
    }
    const auto* first = reinterpret_cast<const std::byte*>(texels.get());
    return {width, height, GraphicsFormat::R8G8B8A8_SRGB,
            std::vector<std::byte>(first, first + std::size_t{4} * static_cast<unsigned>(width) *
                                                      static_cast<unsigned>(height))};
}

} // namespace

std::uint16_t HalfOf(float value)
{
    constexpr float k_Largest = 65504.0f;
    return std::isnan(value) ? std::uint16_t{0}
                             : glm::packHalf1x16(std::clamp(value, -k_Largest, k_Largest));
}

bool IsPictureFile(const std::filesystem::path& path)
{
    return IsIn(ToLower(path.extension().string()),
                {".png", ".tif", ".tiff", ".jpg", ".jpeg", ".tga", ".bmp", ".psd", ".exr", ".hdr"});
}

Image DecodePicture(const std::filesystem::path& path, std::string_view bytes)
{
    const std::string ending = FormatOf(path, bytes);
    if (ending == ".png")
    {
        return DecodePng(bytes, path.generic_string());
    }
    const auto requireSize = [&](std::uint32_t width, std::uint32_t height)
    {
        RequireSize(path, width, height, bytes.size());
    };
    return ending == ".exr"                        ? DecodeExr(path, bytes, requireSize)
           : ending == ".hdr"                      ? DecodeHdr(path, bytes, requireSize)
           : ending == ".tif" || ending == ".tiff" ? ReadTiff(path, bytes)
                                                   : ReadByStb(path, bytes);
}

} // namespace limn
