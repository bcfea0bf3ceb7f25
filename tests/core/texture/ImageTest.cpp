#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <limn/base/Diagnostic.h>
#include <limn/core/Image.h>
#include <random>

#include "FileSizeLimit.h"
#include "Mentions.h"
#include "TemporaryFolder.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

using test::FileSizeLimit;
using test::Mentions;
using test::TemporaryFolder;
using test::ThrownMessage;

/// 2x1, palette (255, 128, 0, opaque) and (10, 20, 30, alpha 64). This one and the next were put
/// together byte by byte with zlib alone.
const unsigned char k_PalettePng[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44,
    0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x03, 0x00, 0x00, 0x00, 0xc3,
    0xfc, 0x8f, 0xb8, 0x00, 0x00, 0x00, 0x06, 0x50, 0x4c, 0x54, 0x45, 0xff, 0x80, 0x00, 0x0a,
    0x14, 0x1e, 0x29, 0x73, 0xcd, 0x71, 0x00, 0x00, 0x00, 0x02, 0x74, 0x52, 0x4e, 0x53, 0xff,
    0x40, 0x93, 0x6b, 0x71, 0xda, 0x00, 0x00, 0x00, 0x0b, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda,
    0x63, 0x60, 0x60, 0x04, 0x00, 0x00, 0x04, 0x00, 0x02, 0x2c, 0xde, 0x48, 0xad, 0x00, 0x00,
    0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

/// 1x1, RGB with 16 bits each: 0, 0x8080, 0xffff; no gamma stated.
const unsigned char k_Rgb16Png[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44,
    0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x10, 0x02, 0x00, 0x00, 0x00, 0xc0,
    0xe7, 0x8f, 0x9d, 0x00, 0x00, 0x00, 0x0f, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0x60,
    0x60, 0x68, 0x68, 0xf8, 0xff, 0x1f, 0x00, 0x06, 0x84, 0x02, 0xff, 0xff, 0x1b, 0x62, 0xf1,
    0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

std::string_view Bytes(const unsigned char* bytes, std::size_t size)
{
    return {reinterpret_cast<const char*>(bytes), size};
}

std::vector<std::byte> Texels(const std::vector<int>& values)
{
    std::vector<std::byte> texels;
    for (const int value : values)
    {
        texels.push_back(static_cast<std::byte>(value));
    }
    return texels;
}

/// 2x2 in four clearly different texels, one of them half and one wholly transparent.
Image FourTexels(GraphicsFormat format = GraphicsFormat::R8G8B8A8_SRGB)
{
    return {2, 2, format, Texels({255, 0, 0, 255, 0, 128, 0, 255, 0, 0, 1, 128, 200, 100, 50, 0})};
}

/// So many texels of noise that no compressor makes a small file of them.
Image Noise()
{
    Image image{64, 64, GraphicsFormat::R8_UNorm, {}};
    std::uint32_t state = 1;
    for (int i = 0; i < 64 * 64; ++i)
    {
        state = state * 1664525u + 1013904223u;
        image.texels.push_back(static_cast<std::byte>(state >> 24));
    }
    return image;
}

std::string ContentOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(ReadPng, ReadsAPaletteWithAlpha)
{
    const TemporaryFolder folder;
    const auto path = folder.Write("a.png", Bytes(k_PalettePng, sizeof k_PalettePng));
    const Image expected{2, 1, GraphicsFormat::R8G8B8A8_SRGB,
                         Texels({255, 128, 0, 255, 10, 20, 30, 64})};
    EXPECT_EQ(ReadPng(path), expected);
}

TEST(ReadPng, TakesSixteenBitsForSrgbToo)
{
    const TemporaryFolder folder;
    const auto path = folder.Write("a.png", Bytes(k_Rgb16Png, sizeof k_Rgb16Png));
    const Image expected{1, 1, GraphicsFormat::R8G8B8A8_SRGB, Texels({0, 0x80, 255, 255})};
    EXPECT_EQ(ReadPng(path), expected);
}

TEST(ReadPng, SaysThatAFileIsMissing)
{
    const TemporaryFolder folder;
    EXPECT_THAT(ThrownMessage<AssetError>([&] { ReadPng(folder / "none.png"); }),
                Mentions((folder / "none.png").string(), "no such file"));
}

TEST(ReadPng, SaysThatAFileIsNoPng)
{
    const TemporaryFolder folder;
    const auto path = folder.Write("a.png", "GIF89a, as it were");
    EXPECT_THAT(ThrownMessage<AssetError>([&] { ReadPng(path); }),
                Mentions(path.string(), "no readable PNG", "Not a PNG"));
}

TEST(ReadPng, RejectsAFileThatIsCutOff)
{
    const TemporaryFolder folder;
    for (std::size_t size = 0; size < sizeof k_PalettePng - 12; ++size)
    {
        const auto path = folder.Write("a.png", Bytes(k_PalettePng, size));
        EXPECT_THROW(ReadPng(path), AssetError) << "after " << size << " bytes";
    }
}

/// A header that says it is an RGBA picture of this size, and nothing behind it that counts.
std::string HeaderOf(std::uint32_t width, std::uint32_t height)
{
    std::string header = "IHDR";
    for (const std::uint32_t side : {width, height})
    {
        for (int shift = 24; shift >= 0; shift -= 8)
        {
            header += static_cast<char>(side >> shift & 255);
        }
    }
    header += std::string("\x08\x06\0\0\0", 5);
    std::uint32_t crc = ~0u;
    for (const char c : header)
    {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
        {
            crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
        }
    }
    std::string file("\x89PNG\r\n\x1a\n\0\0\0\x0d", 12);
    file += header;
    for (int shift = 24; shift >= 0; shift -= 8)
    {
        file += static_cast<char>(~crc >> shift & 255);
    }
    return file + std::string("\0\0\0\x0cIDAT\x78\xda\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 24);
}

TEST(ReadPng, TakesNoMemoryForAPictureThatTheFileCannotHold)
{
    const TemporaryFolder folder;
    const auto errorOf = [&](std::uint32_t width, std::uint32_t height)
    {
        const auto path = folder.Write("a.png", HeaderOf(width, height));
        return ThrownMessage<AssetError>([&] { ReadPng(path); }).erase(0, path.string().size());
    };
    EXPECT_THAT(errorOf(65535, 65535), Mentions("65535x65535", "at most 16384"));
    EXPECT_THAT(errorOf(1, 16385), Mentions("1x16385", "at most 16384"));
    EXPECT_THAT(errorOf(16384, 16384), Mentions("no readable PNG", "57 bytes", "16384x16384"));
    // As large as 57 bytes could make it, and still there is nothing in them.
    EXPECT_NE(errorOf(120, 120).find("is no readable PNG"), std::string::npos);
}

TEST(ReadPng, ReadsWhatIsCompressedAsWellAsCanBe)
{
    const TemporaryFolder folder;
    for (const GraphicsFormat format : {GraphicsFormat::R8_UNorm, GraphicsFormat::R8G8B8A8_SRGB})
    {
        const std::size_t texel = format == GraphicsFormat::R8_UNorm ? 1 : 4;
        const Image plain{1024, 1024, format, std::vector<std::byte>(1024 * 1024 * texel)};
        WritePng(folder / "a.png", plain);
        EXPECT_EQ(ReadPng(folder / "a.png").width, 1024);
    }
}

TEST(ReadPng, RefusesADeviceAndAPipe)
{
    const TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/zero", folder / "a.png");
    EXPECT_THAT(ThrownMessage<AssetError>([&] { ReadPng(folder / "a.png"); }),
                Mentions((folder / "a.png").string(), "is a device", "file is expected"));
}

TEST(WritePng, KeepsEveryTexelAsItIs)
{
    const TemporaryFolder folder;
    for (const GraphicsFormat format :
         {GraphicsFormat::R8G8B8A8_SRGB, GraphicsFormat::R8G8B8A8_UNorm})
    {
        WritePng(folder / "a.png", FourTexels(format));
        EXPECT_EQ(ReadPng(folder / "a.png"), FourTexels());
    }
}

// Deflate cannot shrink it, and each row has a byte more than its texels.
TEST(WritePng, KeepsNoiseInRowsOfOneTexel)
{
    std::mt19937 random(1);
    Image noise{1, 16000, GraphicsFormat::R8G8B8A8_SRGB, {}};
    std::generate_n(std::back_inserter(noise.texels), 4 * 16000,
                    [&] { return static_cast<std::byte>(random() & 255U); });
    const TemporaryFolder folder;
    WritePng(folder / "a.png", noise);
    EXPECT_EQ(ReadPng(folder / "a.png"), noise);
}

TEST(WritePng, WritesASingleChannelAsGrayscale)
{
    const TemporaryFolder folder;
    WritePng(folder / "a.png", {3, 1, GraphicsFormat::R8_UNorm, Texels({0, 100, 255})});
    const Image expected{3, 1, GraphicsFormat::R8G8B8A8_SRGB,
                         Texels({0, 0, 0, 255, 100, 100, 100, 255, 255, 255, 255, 255})};
    EXPECT_EQ(ReadPng(folder / "a.png"), expected);
    // The header's bit depth and colour type: 8 bits, grayscale.
    EXPECT_EQ(ContentOf(folder / "a.png").substr(24, 2), std::string("\x08\x00", 2));
}

TEST(WritePng, ReplacesAnExistingFileAndLeavesNoOther)
{
    const TemporaryFolder folder;
    folder.Write("a.png", "old");
    WritePng(folder / "a.png", FourTexels());
    EXPECT_EQ(ReadPng(folder / "a.png"), FourTexels());
    EXPECT_EQ(folder.fileCount(), 1);
}

TEST(WritePng, SaysWhyAFolderCannotTakeTheFile)
{
    const TemporaryFolder folder;
    folder.Write("file", "");
    EXPECT_THAT(
        ThrownMessage<AssetError>([&] { WritePng(folder / "missing/a.png", FourTexels()); }),
        Mentions((folder / "missing/a.png").string(), "written", "No such file"));
    EXPECT_THAT(ThrownMessage<AssetError>([&] { WritePng(folder / "file/a.png", FourTexels()); }),
                Mentions((folder / "file/a.png").string(), "written", "Not a directory"));
}

TEST(WritePng, LeavesNoTemporaryFileWhenTheNameIsTaken)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "a.png");
    EXPECT_THAT(ThrownMessage<AssetError>([&] { WritePng(folder / "a.png", FourTexels()); }),
                Mentions((folder / "a.png").string(), "written", "Is a directory"));
    EXPECT_EQ(folder.fileCount(), 1);
}

TEST(WritePng, KeepsTheExistingFileWhenThereIsNoRoomForTheNewOne)
{
    const TemporaryFolder folder;
    folder.Write("a.png", "old");
    const Image noise = Noise();
    const FileSizeLimit limit(1024);
    EXPECT_THAT(ThrownMessage<AssetError>([&] { WritePng(folder / "a.png", noise); }),
                Mentions((folder / "a.png").string(), "written", "File too large"));
    EXPECT_EQ(ContentOf(folder / "a.png"), "old");
    EXPECT_EQ(folder.fileCount(), 1);
}

TEST(WritePng, RejectsFormatsThatPngDoesNotKnow)
{
    const TemporaryFolder folder;
    EXPECT_THAT(
        ThrownMessage<ContractError>(
            [&] { WritePng(folder / "a.png", FourTexels(GraphicsFormat::R16G16B16A16_SFloat)); }),
        Mentions("WritePng", "R16G16B16A16_SFloat", "R8G8B8A8_SRGB", "R8G8B8A8_UNorm", "R8_UNorm"));
    EXPECT_EQ(folder.fileCount(), 0);
}

TEST(WritePng, RejectsAnImageWithoutAllItsTexels)
{
    const TemporaryFolder folder;
    Image image = FourTexels();
    image.texels.pop_back();
    EXPECT_THAT(ThrownMessage<ContractError>([&] { WritePng(folder / "a.png", image); }),
                Mentions("WritePng", "15 bytes", "2x2", "R8G8B8A8_SRGB", "16"));
    EXPECT_THAT(ThrownMessage<ContractError>(
                    [&] {
                        WritePng(folder / "a.png", {0, 2, GraphicsFormat::R8_UNorm, {}});
                    }),
                Mentions("WritePng", "0x2", "at least 1"));
}

TEST(FlipRows, PutsTheLastRowFirst)
{
    const std::vector<std::byte> texels = {std::byte{1}, std::byte{2}, std::byte{3},
                                           std::byte{4}, std::byte{5}, std::byte{6}};
    EXPECT_EQ(FlipRows(texels, 3), (std::vector{std::byte{5}, std::byte{6}, std::byte{3},
                                                std::byte{4}, std::byte{1}, std::byte{2}}));
    EXPECT_EQ(FlipRows(texels, 1), texels);
    EXPECT_EQ(FlipRows({}, 2), std::vector<std::byte>());
}

TEST(FlipRows, RefusesBytesThatAreNoWholeRows)
{
    const std::vector<std::byte> texels(6);
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { FlipRows(texels, 4); }),
              "FlipRows: 6 bytes are not 4 rows");
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { FlipRows(texels, 0); }),
              "FlipRows: 6 bytes are not 0 rows");
}

} // namespace
} // namespace limn
