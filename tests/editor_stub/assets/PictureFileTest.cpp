#include "assets/PictureFile.h"

#include "PictureBytes.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limn/base/Diagnostic.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<int> BytesOf(const Image& image)
{
    std::vector<int> bytes;
    for (const std::byte byte : image.texels)
    {
        bytes.push_back(std::to_integer<int>(byte));
    }
    return bytes;
}

std::vector<int> HalvesOf(const Image& image)
{
    std::vector<int> halves;
    for (std::size_t i = 0; i + 1 < image.texels.size(); i += 2)
    {
        halves.push_back(std::to_integer<int>(image.texels[i]) |
                         std::to_integer<int>(image.texels[i + 1]) << 8);
    }
    return halves;
}

std::string ProblemOfPicture(const std::string& name, const std::string& bytes)
{
    try
    {
        DecodePicture(name, bytes);
    }
    catch (const AssetError& error)
    {
        EXPECT_EQ(error.diagnostics().front().file, name);
        return error.diagnostics().front().message;
    }
    return "";
}

// Halves: 0x3c00 is 1, 0x3800 0.5, 0x4000 2, 0x7bff 65504, 0x7c00 infinite, 0x7e00 no number.
const std::vector<std::uint16_t> k_ExrHalves = {0x3800, 0x3c00, 0x7c00, 0x0000,
                                                0x4000, 0x7e00, 0x3c00, 0xfc00};

TEST(PictureFile, TiffHasItsFourthSampleAsAlphaAndMorePreciseOnesRounded)
{
    const Image four =
        DecodePicture("a.tif", TiffBytesOf<std::uint8_t>(2, 1, 4, {1, 2, 3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(four.format, GraphicsFormat::R8G8B8A8_SRGB);
    EXPECT_THAT(BytesOf(four), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
    const Image grey = DecodePicture("a.TIFF", TiffBytesOf<std::uint8_t>(2, 1, 1, {9, 200}));
    EXPECT_THAT(BytesOf(grey), ElementsAre(9, 9, 9, 255, 200, 200, 200, 255));
    const Image wide =
        DecodePicture("a.tif", TiffBytesOf<std::uint16_t>(1, 1, 3, {0, 32767, 65535}));
    EXPECT_THAT(BytesOf(wide), ElementsAre(0, 127, 255, 255));
}

TEST(PictureFile, ExrIsLinearAndFinite)
{
    const Image image = DecodePicture("a.exr", ExrBytesOf(2, 1, "ABGR", k_ExrHalves));
    EXPECT_EQ(image.format, GraphicsFormat::R16G16B16A16_SFloat);
    // In the file A of both texels comes first, then B, G and R.
    EXPECT_THAT(HalvesOf(image),
                ElementsAre(0x3c00, 0x4000, 0x7bff, 0x3800, 0xfbff, 0x0000, 0x0000, 0x3c00));
    const Image grey = DecodePicture("a.exr", ExrBytesOf(1, 2, "Y", {0x3800, 0x4000}));
    EXPECT_EQ(grey.height, 2);
    EXPECT_THAT(HalvesOf(grey),
                ElementsAre(0x3800, 0x3800, 0x3800, 0x3c00, 0x4000, 0x4000, 0x4000, 0x3c00));
}

TEST(PictureFile, RadianceHdrIsLinear)
{
    // (r, g, b) * 2^(e - 136)
    const Image image = DecodePicture("a.hdr", HdrBytesOf(1, 2, {128, 64, 0, 129, 0, 0, 0, 0}));
    EXPECT_EQ(image.format, GraphicsFormat::R16G16B16A16_SFloat);
    EXPECT_THAT(HalvesOf(image),
                ElementsAre(0x3c00, 0x3800, 0x0000, 0x3c00, 0x0000, 0x0000, 0x0000, 0x3c00));
    // 255 * 2^(255 - 136) is more than 16 bits hold.
    EXPECT_EQ(HalvesOf(DecodePicture("a.hdr", HdrBytesOf(1, 1, {255, 255, 255, 255}))).at(0),
              0x7bff);
}

// Eight texels of a row: runs of red, of green and of the exponent, blue as it is.
const std::string k_PackedHdr =
    HdrBytesOf(8, 1, {2, 2, 0, 8, 136, 128, 136, 64, 8, 0, 1, 2, 3, 4, 5, 6, 7, 136, 129});

TEST(PictureFile, RadianceHdrMayBePacked)
{
    const Image image = DecodePicture("a.hdr", k_PackedHdr);
    const std::vector<int> halves = HalvesOf(image);
    ASSERT_EQ(halves.size(), 32u);
    for (std::size_t i = 0; i < 8; ++i)
    {
        EXPECT_EQ(halves[4 * i], 0x3c00);
        EXPECT_EQ(halves[4 * i + 1], 0x3800);
        EXPECT_EQ(halves[4 * i + 3], 0x3c00);
    }
    EXPECT_EQ(halves[2], 0x0000);
    EXPECT_EQ(halves[4 * 4 + 2], 0x2800); // 4 / 128 = 2^-5
    EXPECT_THAT(ProblemOfPicture("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n1234"),
                HasSubstr("32-bit_rle_rgbe"));
    EXPECT_THAT(ProblemOfPicture("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n+X 1 -Y 1\n1234"),
                HasSubstr("-Y 512 +X 1024"));
}

TEST(PictureFile, TgaStandsUpright)
{
    const Image image = DecodePicture("a.tga", TgaBytesOf(1, 2, {1, 2, 3, 4, 5, 6, 7, 8}));
    EXPECT_THAT(BytesOf(image), ElementsAre(7, 6, 5, 8, 3, 2, 1, 4));
}

TEST(PictureFile, IsRefusedBeforeMemoryIsTakenForASizeThatNoFileHolds)
{
    std::string tiff = TiffBytesOf<std::uint8_t>(2, 1, 4, {1, 2, 3, 4, 5, 6, 7, 8});
    const std::size_t widthAt = tiff.find(std::string("\0\1\4\0\1\0\0\0", 8)) + 8;
    const std::uint32_t huge = 1'000'000'000;
    std::memcpy(tiff.data() + widthAt, &huge, 4);
    EXPECT_THAT(ProblemOfPicture("a.tif", tiff), HasSubstr("1000000000x1"));
    EXPECT_THAT(ProblemOfPicture("a.exr", ExrBytesOf(1'000'000'000, 1'000'000'000, "ABGR", {})),
                HasSubstr("OpenEXR"));
    EXPECT_THAT(ProblemOfPicture("a.exr", ExrBytesOf(16384, 16384, "ABGR", {})),
                HasSubstr("OpenEXR"));
    EXPECT_THAT(ProblemOfPicture("a.hdr", HdrBytesOf(1'000'000, 1'000'000, {1, 1, 1, 1})),
                testing::AnyOf(HasSubstr("texels"), HasSubstr("Radiance")));
    EXPECT_THAT(ProblemOfPicture("a.tga", TgaBytesOf(16384, 16384, {0, 0, 0, 0})),
                HasSubstr("cannot hold a picture of 16384x16384"));
    EXPECT_THAT(ProblemOfPicture("a.tga", TgaBytesOf(65535, 1, {0, 0, 0, 0})),
                HasSubstr("65535x1"));
}

TEST(PictureFile, IsRefusedWithASentenceWhereItIsCutOff)
{
    const std::pair<std::string, std::string> files[] = {
        {"a.tif", TiffBytesOf<std::uint8_t>(2, 1, 4, {1, 2, 3, 4, 5, 6, 7, 8})},
        {"a.exr", ExrBytesOf(2, 1, "ABGR", k_ExrHalves)},
        {"a.hdr", HdrBytesOf(1, 2, {128, 64, 0, 129, 0, 0, 0, 0})},
        {"a.hdr", k_PackedHdr}, // stb_image 2.27 never ends where it is cut off
        {"a.tga", TgaBytesOf(1, 2, {1, 2, 3, 4, 5, 6, 7, 8})},
    };
    for (const auto& [name, bytes] : files)
    {
        EXPECT_NO_THROW(DecodePicture(name, bytes)) << name;
        for (std::size_t size = 0; size < bytes.size(); ++size)
        {
            try
            {
                DecodePicture(name, bytes.substr(0, size)); // some end with what nobody needs
            }
            catch (const AssetError& error)
            {
                EXPECT_FALSE(error.diagnostics().front().message.empty());
            }
        }
        EXPECT_NE(ProblemOfPicture(name, ""), "") << name;
        EXPECT_NE(ProblemOfPicture(name, bytes.substr(0, bytes.size() / 4)), "") << name;
        EXPECT_NE(ProblemOfPicture(name, "no picture at all"), "") << name;
    }
}

TEST(PictureFile, OfAnotherFormatThanItsNameIsReadAllTheSame)
{
    const std::string tiff = TiffBytesOf<std::uint8_t>(2, 1, 4, {1, 2, 3, 4, 5, 6, 7, 8});
    EXPECT_EQ(DecodePicture("a.png", tiff), DecodePicture("a.tif", tiff));
    const std::string exr = ExrBytesOf(2, 1, "ABGR", k_ExrHalves);
    EXPECT_EQ(DecodePicture("a.jpg", exr), DecodePicture("a.exr", exr));
    const std::string hdr = HdrBytesOf(1, 2, {128, 64, 0, 129, 0, 0, 0, 0});
    EXPECT_EQ(DecodePicture("a.tga", hdr), DecodePicture("a.hdr", hdr));
}

} // namespace
} // namespace limn::test
