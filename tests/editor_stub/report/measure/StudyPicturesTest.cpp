#include "report/measure/StudyPicture.h"

#include <gtest/gtest.h>

namespace limn::test
{

namespace
{

/// Each texel has its column as red and its row as green, and no alpha.
Image Numbered(int width, int height)
{
    Image image{width, height, GraphicsFormat::R8G8B8A8_SRGB, {}};
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            image.texels.insert(image.texels.end(),
                                {std::byte(x), std::byte(y), std::byte{7}, std::byte{0}});
        }
    }
    return image;
}

/// The column and the row that a texel of a part of Numbered came from.
std::pair<int, int> Origin(const Image& image, int x, int y)
{
    const auto at = static_cast<std::size_t>(4 * (y * image.width + x));
    EXPECT_EQ(std::byte{7}, image.texels[at + 2]);
    EXPECT_EQ(std::byte{255}, image.texels[at + 3]) << "it is opaque";
    return {std::to_integer<int>(image.texels[at]), std::to_integer<int>(image.texels[at + 1])};
}

TEST(EnlargedPart, RepeatsEachTexelOfTheWindow)
{
    const Image part = study::EnlargedPart(Numbered(100, 50), {20, 10, 8, 3});
    ASSERT_EQ(24, part.width);
    ASSERT_EQ(24, part.height);
    EXPECT_EQ(std::pair(20, 10), Origin(part, 0, 0));
    EXPECT_EQ(std::pair(20, 10), Origin(part, 2, 2));
    EXPECT_EQ(std::pair(21, 10), Origin(part, 3, 2));
    EXPECT_EQ(std::pair(27, 17), Origin(part, 23, 23));
}

TEST(EnlargedPart, StaysWithinTheImage)
{
    const Image image = Numbered(100, 50);
    EXPECT_EQ(std::pair(0, 0), Origin(study::EnlargedPart(image, {-5, -9, 8, 1}), 0, 0));
    EXPECT_EQ(std::pair(92, 42), Origin(study::EnlargedPart(image, {99, 60, 8, 1}), 0, 0));
    const Image cut = study::EnlargedPart(image, {30, 30, 64, 2});
    EXPECT_EQ(128, cut.width);
    EXPECT_EQ(100, cut.height) << "the image has 50 rows";
    EXPECT_EQ(std::pair(30, 0), Origin(cut, 0, 0));
}

TEST(CloseUp, HasTheSameMiddleAndRoomForTheOutline)
{
    const study::PictureWindow window{100, 200, 64, 4}; // its middle is (132, 232)
    const study::PictureWindow near = study::CloseUp(window, 4.0, 1.0);
    EXPECT_EQ(132, near.x + near.side / 2);
    EXPECT_EQ(232, near.y + near.side / 2);
    EXPECT_GE(near.side * near.scale, 200) << "it is large enough to be seen";
    const study::PictureWindow wide = study::CloseUp(window, 50.0, 1.0);
    EXPECT_GE(wide.side, 150) << "an outline of 50 px and the object beside it";
    const study::PictureWindow doubled = study::CloseUp(window, 4.0, 2.0);
    EXPECT_EQ(264, doubled.x + doubled.side / 2) << "the picture has twice the pixels";
}

} // namespace

} // namespace limn::test
