#include <gtest/gtest.h>
#include <limn/volume/TextureCurve.h>

namespace limn
{

namespace
{

TEST(TextureCurve, SamplesInStepsOfOneOver128)
{
    const TextureCurve line(AnimationCurve({{0, 0, 2, 2}, {1, 2, 2, 2}}), 0.0f, false,
                            {0.0f, 1.0f});
    const auto samples = line.Samples();
    EXPECT_EQ(samples[0], 0.0f);
    EXPECT_FLOAT_EQ(samples[64], 1.0f);
    EXPECT_FLOAT_EQ(samples[127], 2.0f * 127.0f / 128.0f);
    const auto texture = line.MakeTexture();
    EXPECT_EQ(texture->width(), 128);
    EXPECT_EQ(texture->height(), 1);
    EXPECT_EQ(texture->graphicsFormat(), GraphicsFormat::R16_SFloat);
    EXPECT_EQ(texture->texels()[128], std::byte{0x00}); // 1.0 is 0x3C00 as a half
    EXPECT_EQ(texture->texels()[129], std::byte{0x3C});
}

TEST(TextureCurve, IsItsZeroValueWithoutKeys)
{
    const TextureCurve none({}, 0.5f, true, {0.0f, 1.0f});
    EXPECT_EQ(none.Evaluate(0.3f), 0.5f);
    EXPECT_EQ(none.Samples()[100], 0.5f);
}

TEST(TextureCurve, GoesOnIntoItsBeginningWhenItLoops)
{
    const AnimationCurve keys({{0.25f, 1}, {0.75f, 3}});
    const TextureCurve still(keys, 0.0f, false, {0.0f, 1.0f});
    const TextureCurve loop(keys, 0.0f, true, {0.0f, 1.0f});
    EXPECT_EQ(still.Evaluate(0.0f), 1.0f);
    EXPECT_EQ(still.Evaluate(1.0f), 3.0f);
    // Half-way between (-0.25, 3) and (0.25, 1), and between (0.75, 3) and (1.25, 1).
    EXPECT_FLOAT_EQ(loop.Evaluate(0.0f), 2.0f);
    EXPECT_FLOAT_EQ(loop.Evaluate(1.0f), 2.0f);
    EXPECT_FLOAT_EQ(TextureCurve(keys, 0.0f, true, {3.0f, 4.0f}).range(), 5.0f);
}

} // namespace

} // namespace limn
