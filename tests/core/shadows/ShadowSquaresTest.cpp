#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "shadows/ShadowSquares.h"

namespace limn
{
namespace
{

std::vector<ViewportRect> Place(const std::vector<ShadowSquares>& requests, int size)
{
    std::vector<ViewportRect> result;
    PlaceShadowSquares(requests, size, result);
    return result;
}

TEST(ShadowSquaresOfLights, AreAsLargeAsTheyAskForWhereThereIsRoom)
{
    // Two of 1024, four of 512 and four of 256 on a map of 2048: three quarters of it and more.
    const auto squares = Place({{256, 8, 4}, {1024, 8, 1}, {512, 8, 4}, {1024, 8, 1}}, 2048);
    ASSERT_EQ(squares.size(), 10u);
    EXPECT_EQ(squares[4], (ViewportRect{0, 0, 1024, 1024}));
    EXPECT_EQ(squares[9], (ViewportRect{1024, 0, 1024, 1024}));
    EXPECT_EQ(squares[5], (ViewportRect{0, 1024, 512, 512}));
    EXPECT_EQ(squares[8], (ViewportRect{512, 1536, 512, 512}));
    EXPECT_EQ(squares[0], (ViewportRect{1024, 1024, 256, 256}));
    EXPECT_EQ(squares[3], (ViewportRect{1280, 1280, 256, 256}));
}

TEST(ShadowSquaresOfLights, AreAllHalvedUntilTheyFit)
{
    // A point of URP's tier High: six of 1024 do not fit into 2048, six of 512 do.
    for (const ViewportRect& square : Place({{1024, 8, 6}}, 2048))
    {
        EXPECT_EQ(square.width, 512);
    }
    const auto mixed = Place({{1024, 8, 6}, {256, 8, 1}}, 2048);
    EXPECT_EQ(mixed[0].width, 512);
    EXPECT_EQ(mixed[6].width, 128) << "by the same factor";
    EXPECT_EQ(Place({{4096, 8, 1}}, 1024)[0].width, 1024) << "no larger than the map";
    EXPECT_EQ(Place({{300, 8, 1}}, 1000)[0].width, 256) << "powers of two";
}

TEST(ShadowSquaresOfLights, AreLeftOutWhereTheyWouldBeTooSmall)
{
    // Nine of 16 do not fit into 32; of 8 they do, which is too small for soft ones.
    std::vector<ShadowSquares> lights(9, {16, 8, 1});
    for (const ViewportRect& square : Place(lights, 32))
    {
        EXPECT_EQ(square.width, 8);
    }
    lights.assign(9, {16, 16, 1});
    const auto squares = Place(lights, 32);
    for (std::size_t i = 0; i < 9; ++i)
    {
        EXPECT_EQ(squares[i].width, i < 4 ? 16 : 0) << "those that come first are kept";
    }
    EXPECT_TRUE(Place({}, 64).empty());
}

TEST(ShadowSquaresOfLights, NeverOverlap)
{
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round)
    {
        std::vector<ShadowSquares> requests(1 + random() % 12);
        for (ShadowSquares& request : requests)
        {
            request = {static_cast<int>(16 + random() % 2000), random() % 2 == 0 ? 8 : 16,
                       random() % 3 == 0 ? 6 : 1};
        }
        const int size = 64 + static_cast<int>(random() % 1000);
        const auto squares = Place(requests, size);
        for (std::size_t i = 0; i < squares.size(); ++i)
        {
            const ViewportRect& a = squares[i];
            EXPECT_TRUE(a.x >= 0 && a.y >= 0 && a.x + a.width <= size && a.y + a.height <= size);
            EXPECT_EQ(a.width, a.height);
            for (std::size_t k = 0; k < i; ++k)
            {
                const ViewportRect& b = squares[k];
                EXPECT_TRUE(a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y ||
                            b.y + b.height <= a.y)
                    << round << ": " << i << " and " << k;
            }
        }
    }
}

} // namespace
} // namespace limn
