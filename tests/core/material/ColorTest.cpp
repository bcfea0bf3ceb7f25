#include <array>
#include <gtest/gtest.h>
#include <limn/core/Color.h>

namespace limn
{
namespace
{

void ExpectNear(const Color& color, const std::array<double, 3>& expected)
{
    EXPECT_NEAR(color.r, expected[0], 1e-6);
    EXPECT_NEAR(color.g, expected[1], 1e-6);
    EXPECT_NEAR(color.b, expected[2], 1e-6);
    EXPECT_EQ(color.a, 1.0f);
}

// Values of the hexcone, worked out by hand.
struct HueRow
{
    float h, s, v;
    std::array<double, 3> rgb;
};
constexpr HueRow k_Hues[] = {
    {0.0f, 1.0f, 1.0f, {1, 0, 0}},        {1.0f / 6, 1.0f, 1.0f, {1, 1, 0}},
    {1.0f / 3, 1.0f, 0.5f, {0, 0.5, 0}},  {0.5f, 0.5f, 0.8f, {0.4, 0.8, 0.8}},
    {2.0f / 3, 1.0f, 1.0f, {0, 0, 1}},    {5.0f / 6, 0.25f, 1.0f, {1, 0.75, 1}},
    {1.0f / 12, 1.0f, 1.0f, {1, 0.5, 0}}, {0.95f, 1.0f, 1.0f, {1, 0, 0.3}},
    {0.0f, 0.0f, 0.7f, {0.7, 0.7, 0.7}},
};

TEST(Color, HasAHue)
{
    for (const HueRow& row : k_Hues)
    {
        const Color color = Color::HSVToRGB(row.h, row.s, row.v);
        ExpectNear(color, row.rgb);
        float h = -1.0f;
        float s = -1.0f;
        float v = -1.0f;
        Color::RGBToHSV(color, h, s, v);
        EXPECT_NEAR(h, row.h, 1e-6);
        EXPECT_NEAR(s, row.s, 1e-6);
        EXPECT_NEAR(v, row.v, 1e-6);
    }
    ExpectNear(Color::HSVToRGB(1.0f, 1.0f, 1.0f), {1, 0, 0});
    ExpectNear(Color::HSVToRGB(0.0f, 0.5f, 4.0f), {4, 2, 2});
    // Twice a colour of one component at 1 and two at 0.25; above 1 goes, each by itself.
    ExpectNear(Color::HSVToRGB(0.0f, 0.75f, 2.0f, false), {1, 0.5, 0.5});
    ExpectNear(Color::HSVToRGB(1.0f / 3, 0.75f, 2.0f, false), {0.5, 1, 0.5});
    ExpectNear(Color::HSVToRGB(2.0f / 3, 0.75f, 2.0f, false), {0.5, 0.5, 1});
    float h = -1.0f;
    float s = -1.0f;
    float v = -1.0f;
    Color::RGBToHSV(Color::black, h, s, v);
    EXPECT_EQ(h, 0.0f);
    EXPECT_EQ(s, 0.0f);
    EXPECT_EQ(v, 0.0f);
}

TEST(Color, IsCalculatedWith)
{
    constexpr Color a(0.25f, 0.5f, 1.0f, 0.5f);
    constexpr Color b(0.75f, 0.0f, 0.5f, 1.0f);
    EXPECT_EQ(a + b, Color(1.0f, 0.5f, 1.5f, 1.5f));
    EXPECT_EQ(a * b, Color(0.1875f, 0.0f, 0.5f, 0.5f));
    EXPECT_EQ(2.0f * a, Color(0.5f, 1.0f, 2.0f, 1.0f));
    EXPECT_EQ(a / 2.0f, Color(0.125f, 0.25f, 0.5f, 0.25f));
    EXPECT_EQ(Color::Lerp(a, b, 0.5f), Color(0.5f, 0.25f, 0.75f, 0.75f));
    EXPECT_EQ(Color::Lerp(a, b, 3.0f), b);
    EXPECT_EQ(Color::LerpUnclamped(a, b, 2.0f), Color(1.25f, -0.5f, 0.0f, 1.5f));
    EXPECT_EQ(a.maxColorComponent(), 1.0f);
    EXPECT_NEAR(a.grayscale(), 0.299 * 0.25 + 0.587 * 0.5 + 0.114, 1e-6);
}

TEST(Color32OfFourBytes, IsAColourAndBack)
{
    const Color color = Color32(0, 51, 255, 128);
    EXPECT_EQ(color.r, 0.0f);
    EXPECT_FLOAT_EQ(color.g, 0.2f);
    EXPECT_EQ(color.b, 1.0f);
    EXPECT_FLOAT_EQ(color.a, 128.0f / 255.0f);
    for (int byte = 0; byte < 256; ++byte)
    {
        const auto part = static_cast<std::uint8_t>(byte);
        const Color32 before(part, 0, part, 255);
        EXPECT_EQ(Color32(Color(before)), before);
    }
    EXPECT_EQ(Color32(Color(-1.0f, 2.0f, 0.499f, 1.0f)), Color32(0, 255, 127, 255))
        << "0.499 * 255 = 127.2";
}

} // namespace
} // namespace limn
