#include "assets/PictureSettings.h"

#include <cmath>
#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::ElementsAreArray;

Image PictureOf(int width, int height, const std::vector<int>& bytes)
{
    Image image{width, height, GraphicsFormat::R8G8B8A8_SRGB, {}};
    for (const int byte : bytes)
    {
        image.texels.push_back(static_cast<std::byte>(byte));
    }
    return image;
}

std::vector<int> TexelsWith(Image image, const PictureSettings& settings)
{
    std::vector<int> bytes;
    for (const std::byte byte : ApplyPictureSettings(std::move(image), settings).texels)
    {
        bytes.push_back(std::to_integer<int>(byte));
    }
    return bytes;
}

double Decoded(double byte)
{
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

int Encoded(double linear)
{
    const double c =
        linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    return static_cast<int>(std::lround(c * 255.0));
}

TEST(PictureSettings, ChangeNothingByDefault)
{
    std::vector<int> every;
    for (int i = 0; i < 256; ++i)
    {
        every.insert(every.end(), {i, 255 - i, (i * 7) % 256, (i * 13) % 256});
    }
    EXPECT_THAT(TexelsWith(PictureOf(16, 16, every), {}), ElementsAreArray(every));
    PictureSettings settings;
    settings.sRGB = false;
    EXPECT_EQ(ApplyPictureSettings(PictureOf(16, 16, every), settings).format,
              GraphicsFormat::R8G8B8A8_UNorm);
    settings.maxTextureSize = 16;
    EXPECT_THAT(TexelsWith(PictureOf(16, 16, every), settings), ElementsAreArray(every));
}

TEST(PictureSettings, MakeAlphaOfNothingOrOfGrey)
{
    PictureSettings settings;
    settings.alpha = PictureAlpha::None;
    EXPECT_THAT(TexelsWith(PictureOf(1, 1, {10, 20, 60, 7}), settings),
                ElementsAre(10, 20, 60, 255));
    settings.alpha = PictureAlpha::FromGrayScale;
    EXPECT_THAT(TexelsWith(PictureOf(1, 1, {10, 20, 60, 7}), settings),
                ElementsAre(10, 20, 60, 30));
}

TEST(PictureSettings, SwizzleChannels)
{
    PictureSettings settings;
    settings.swizzle = {PictureSwizzle::A, PictureSwizzle::OneMinusR, PictureSwizzle::Zero,
                        PictureSwizzle::One};
    EXPECT_THAT(TexelsWith(PictureOf(1, 1, {10, 20, 60, 7}), settings),
                ElementsAre(7, 245, 0, 255));
    settings.swizzle = {PictureSwizzle::OneMinusA, PictureSwizzle::OneMinusB,
                        PictureSwizzle::OneMinusG, PictureSwizzle::R};
    EXPECT_THAT(TexelsWith(PictureOf(1, 1, {10, 20, 60, 7}), settings),
                ElementsAre(248, 195, 235, 10));
}

TEST(PictureSettings, ShrinkByTheMeanInLinearSpace)
{
    const std::vector<int> four = {0,   0, 10, 0,   255, 0, 20, 100, //
                                   255, 0, 30, 100, 255, 8, 40, 200};
    PictureSettings settings;
    settings.maxTextureSize = 1;
    EXPECT_THAT(TexelsWith(PictureOf(2, 2, four), settings),
                ElementsAre(Encoded(0.75), Encoded(Decoded(8) / 4),
                            Encoded((Decoded(10) + Decoded(20) + Decoded(30) + Decoded(40)) / 4),
                            100));
    settings.sRGB = false;
    EXPECT_THAT(TexelsWith(PictureOf(2, 2, four), settings), ElementsAre(191, 2, 25, 100));
}

TEST(PictureSettings, ShrinkToTheLongerSideAndByPartsOfTexels)
{
    PictureSettings settings;
    settings.sRGB = false;
    settings.maxTextureSize = 2;
    const Image wide = ApplyPictureSettings(
        PictureOf(3, 1, {0, 0, 0, 0, 90, 90, 90, 90, 240, 240, 240, 240}), settings);
    EXPECT_EQ(wide.width, 2);
    EXPECT_EQ(wide.height, 1);
    // Each covers one texel and a half: (0 + 90 / 2) / 1.5 and (90 / 2 + 240) / 1.5.
    EXPECT_THAT(
        TexelsWith(PictureOf(3, 1, {0, 0, 0, 0, 90, 90, 90, 90, 240, 240, 240, 240}), settings),
        ElementsAre(30, 30, 30, 30, 190, 190, 190, 190));
}

TEST(PictureSettings, MakeNormalMapsLinearWithoutAlpha)
{
    PictureSettings settings;
    settings.isNormalMap = true;
    EXPECT_THAT(TexelsWith(PictureOf(1, 1, {100, 20, 250, 7}), settings),
                ElementsAre(100, 20, 250, 255));
    EXPECT_EQ(ApplyPictureSettings(PictureOf(1, 1, {1, 2, 3, 4}), settings).format,
              GraphicsFormat::R8G8B8A8_UNorm);
    settings.flipGreenChannel = true;
    EXPECT_THAT(TexelsWith(PictureOf(1, 1, {100, 20, 250, 7}), settings),
                ElementsAre(100, 235, 250, 255));
}

TEST(PictureSettings, MakeNormalsOfHeights)
{
    PictureSettings settings;
    settings.isNormalMap = true;
    settings.convertToNormalMap = true;
    const std::vector<int> flat = {128, 128, 255, 255};
    EXPECT_THAT(TexelsWith(PictureOf(1, 1, {90, 90, 90, 255}), settings), ElementsAreArray(flat));
    // Grey grows to the right: the normal in the middle leans to the left. Grey grows to the top
    // row: the normal leans down.
    const std::vector<int> right =
        TexelsWith(PictureOf(3, 1, {0, 0, 0, 255, 9, 9, 9, 255, 18, 18, 18, 255}), settings);
    EXPECT_LT(right.at(4), 100);
    EXPECT_EQ(right.at(5), 128);
    const std::vector<int> up =
        TexelsWith(PictureOf(1, 3, {18, 18, 18, 255, 9, 9, 9, 255, 0, 0, 0, 255}), settings);
    EXPECT_EQ(up.at(4), 128);
    EXPECT_LT(up.at(5), 100);
}

TEST(PictureSettings, KeepLinearPicturesOf16BitsAChannel)
{
    Image image{2, 1, GraphicsFormat::R16G16B16A16_SFloat, std::vector<std::byte>(16)};
    image.texels[1] = std::byte{0x44};  // red of the first is 4
    image.texels[15] = std::byte{0x3c}; // alpha of the second is 1
    PictureSettings settings;
    EXPECT_EQ(ApplyPictureSettings(image, settings), image);
    settings.maxTextureSize = 1;
    const Image shrunk = ApplyPictureSettings(image, settings);
    EXPECT_EQ(shrunk.format, GraphicsFormat::R16G16B16A16_SFloat);
    EXPECT_EQ(shrunk.texels[1], std::byte{0x40}); // 2
    EXPECT_EQ(shrunk.texels[7], std::byte{0x38}); // 0.5
}

} // namespace
} // namespace limn::test
