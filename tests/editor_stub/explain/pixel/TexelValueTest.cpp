#include "explain/pixel/PixelHistory.h"

#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

using Floats = std::vector<float>;
using testing::FloatNear;
using testing::Pointwise;

Floats Value(const std::vector<int>& bytes, GraphicsFormat format)
{
    std::vector<std::byte> texel;
    for (const int byte : bytes)
    {
        texel.push_back(static_cast<std::byte>(byte));
    }
    EXPECT_EQ(static_cast<std::size_t>(BytesPerTexel(format)), texel.size()) << ToString(format);
    return TexelValue(texel, format);
}

} // namespace

TEST(TexelValue, IsWhatShadersSeeOfBytes)
{
    EXPECT_EQ((Floats{1.0f, 0.0f, 0.2f, 0.4f}),
              Value({255, 0, 51, 102}, GraphicsFormat::R8G8B8A8_UNorm));
    EXPECT_EQ((Floats{0.2f, 0.0f, 1.0f, 0.4f}),
              Value({255, 0, 51, 102}, GraphicsFormat::B8G8R8A8_UNorm));
    EXPECT_EQ((Floats{-1.0f, 1.0f}), Value({128, 127}, GraphicsFormat::R8G8_SNorm));
    EXPECT_EQ((Floats{200.0f}), Value({200}, GraphicsFormat::R8_UInt));
    EXPECT_EQ((Floats{-56.0f}), Value({200}, GraphicsFormat::R8_SInt));
    EXPECT_EQ((Floats{258.0f, 1.0f}), Value({2, 1, 1, 0}, GraphicsFormat::R16G16_UInt));
}

TEST(TexelValue, IsLinearWhereTheTextureIsSRGBAndAlphaStaysAsItIs)
{
    // 188 is the sRGB value nearest to half the light.
    const Floats value = Value({188, 0, 255, 51}, GraphicsFormat::R8G8B8A8_SRGB);
    EXPECT_THAT(value, Pointwise(FloatNear(0.003f), Floats{0.5f, 0.0f, 1.0f, 0.2f}));
    EXPECT_EQ(0.2f, value.back());
}

TEST(TexelValue, ReadsFloatsOfEverySize)
{
    EXPECT_EQ((Floats{1.0f, -2.0f, 0.5f, 0.0f}), Value({0x00, 0x3C, 0x00, 0xC0, 0x00, 0x38, 0, 0},
                                                       GraphicsFormat::R16G16B16A16_SFloat));
    EXPECT_EQ((Floats{1.5f}), Value({0, 0, 0xC0, 0x3F}, GraphicsFormat::R32_SFloat));
    EXPECT_EQ((Floats{1.5f}), Value({0, 0, 0xC0, 0x3F}, GraphicsFormat::D32_SFloat));
    // Exponent 15 is 1; red 1 at bit 0, green 2 at bit 11, blue 0.5 at bit 22.
    constexpr std::uint32_t packed = 15u << 6 | (16u << 6) << 11 | (14u << 5) << 22;
    const auto byte = [](int i)
    {
        return static_cast<int>((packed >> (8 * i)) & 255u);
    };
    EXPECT_EQ((Floats{1.0f, 2.0f, 0.5f}),
              Value({byte(0), byte(1), byte(2), byte(3)}, GraphicsFormat::B10G11R11_UFloatPack32));
    // Mantissas of 9 bits, red lowest, and an exponent of 16: 256 / 512 * 2.
    const std::uint32_t shared = 256u | 128u << 9 | 0u << 18 | 16u << 27;
    EXPECT_EQ((Floats{1.0f, 0.5f, 0.0f}),
              Value({static_cast<int>(shared & 255u), static_cast<int>((shared >> 8) & 255u),
                     static_cast<int>((shared >> 16) & 255u), static_cast<int>(shared >> 24)},
                    GraphicsFormat::E5B9G9R9_UFloatPack32));
}

TEST(TexelValue, TakesPackedComponentsFromTheHighestBitOn)
{
    EXPECT_EQ((Floats{1.0f, 0.0f, 0.0f}), Value({0x00, 0xF8}, GraphicsFormat::R5G6B5_UNormPack16));
    EXPECT_EQ((Floats{0.0f, 0.0f, 1.0f, 1.0f}),
              Value({0x00, 0x00, 0xF0, 0xFF}, GraphicsFormat::A2B10G10R10_UNormPack32));
    EXPECT_EQ((Floats{0.0f, 0.0f, 0.0f, 1.0f}),
              Value({0x00, 0x80}, GraphicsFormat::A1R5G5B5_UNormPack16));
}

} // namespace limn::test
