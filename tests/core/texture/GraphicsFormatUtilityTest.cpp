#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <limn/core/GraphicsFormatUtility.h>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

using enum GraphicsFormat;
using Utility = GraphicsFormatUtility;

} // namespace

TEST(GraphicsFormatUtility, KnowsThePairsOfSRGB)
{
    const std::pair<GraphicsFormat, GraphicsFormat> pairs[] = {
        {R8_SRGB, R8_UNorm},
        {R8G8_SRGB, R8G8_UNorm},
        {R8G8B8_SRGB, R8G8B8_UNorm},
        {R8G8B8A8_SRGB, R8G8B8A8_UNorm},
        {B8G8R8_SRGB, B8G8R8_UNorm},
        {B8G8R8A8_SRGB, B8G8R8A8_UNorm},
        {RGBA_DXT1_SRGB, RGBA_DXT1_UNorm},
        {RGBA_DXT5_SRGB, RGBA_DXT5_UNorm},
        {RGBA_BC7_SRGB, RGBA_BC7_UNorm},
        {RGBA_ASTC12X12_SRGB, RGBA_ASTC12X12_UNorm},
        {RGB_A1_ETC2_SRGB, RGB_A1_ETC2_UNorm},
        {A2R10G10B10_XRSRGBPack32, A2R10G10B10_XRUNormPack32}};
    for (const auto& [sRGB, linear] : pairs)
    {
        EXPECT_EQ(Utility::GetSRGBFormat(linear), sRGB) << ToString(linear);
        EXPECT_EQ(Utility::GetLinearFormat(sRGB), linear) << ToString(sRGB);
        EXPECT_TRUE(Utility::IsSRGBFormat(sRGB) && !Utility::IsSRGBFormat(linear));
    }
    for (const GraphicsFormat alone :
         {R16_UNorm, R16G16B16A16_SFloat, R_BC4_UNorm, A2B10G10R10_UNormPack32, D16_UNorm})
    {
        EXPECT_EQ(Utility::GetSRGBFormat(alone), alone) << ToString(alone);
        EXPECT_EQ(Utility::GetLinearFormat(alone), alone) << ToString(alone);
    }
}

TEST(GraphicsFormatUtility, KnowsBlocks)
{
    struct Block
    {
        GraphicsFormat format;
        std::uint32_t width, height, bytes;
    };
    // By the formats' specifications.
    for (const Block& block :
         {Block{RGBA_DXT1_UNorm, 4, 4, 8}, Block{RGBA_DXT5_SRGB, 4, 4, 16},
          Block{R_BC4_SNorm, 4, 4, 8}, Block{RG_BC5_UNorm, 4, 4, 16},
          Block{RGB_BC6H_UFloat, 4, 4, 16}, Block{RGB_PVRTC_2Bpp_UNorm, 8, 4, 8},
          Block{RGBA_PVRTC_4Bpp_SRGB, 4, 4, 8}, Block{RGB_ETC_UNorm, 4, 4, 8},
          Block{RGB_A1_ETC2_UNorm, 4, 4, 8}, Block{RGBA_ETC2_SRGB, 4, 4, 16},
          Block{R_EAC_UNorm, 4, 4, 8}, Block{RG_EAC_SNorm, 4, 4, 16},
          Block{RGBA_ASTC5X5_UNorm, 5, 5, 16}, Block{RGBA_ASTC12X12_UFloat, 12, 12, 16},
          Block{R8G8B8A8_UNorm, 1, 1, 4}})
    {
        EXPECT_EQ(Utility::GetBlockWidth(block.format), block.width) << ToString(block.format);
        EXPECT_EQ(Utility::GetBlockHeight(block.format), block.height) << ToString(block.format);
        EXPECT_EQ(Utility::GetBlockSize(block.format), block.bytes) << ToString(block.format);
        EXPECT_EQ(Utility::IsCompressedFormat(block.format), block.width > 1);
    }
    EXPECT_EQ(Utility::ComputeMipmapSize(5, 4, RGBA_BC7_UNorm), 2u * 1u * 16u);
    EXPECT_EQ(Utility::ComputeMipmapSize(5, 4, R16G16_SFloat), 5u * 4u * 4u);
}

TEST(GraphicsFormatUtility, CountsComponents)
{
    const auto components = [](GraphicsFormat format)
    {
        return std::pair(Utility::GetColorComponentCount(format),
                         Utility::GetAlphaComponentCount(format));
    };
    EXPECT_EQ(components(R8G8B8A8_SRGB), std::pair(3u, 1u));
    EXPECT_EQ(components(R16G16_SNorm), std::pair(2u, 0u));
    EXPECT_EQ(components(A1R5G5B5_UNormPack16), std::pair(3u, 1u));
    EXPECT_EQ(components(RGB_A1_ETC2_UNorm), std::pair(3u, 1u));
    EXPECT_EQ(components(RGB_ETC2_SRGB), std::pair(3u, 0u));
    EXPECT_EQ(components(R_EAC_UNorm), std::pair(1u, 0u));
    EXPECT_EQ(components(E5B9G9R9_UFloatPack32), std::pair(3u, 0u));
    EXPECT_EQ(components(D32_SFloat_S8_UInt), std::pair(0u, 0u));
    EXPECT_TRUE(Utility::HasAlphaChannel(RGBA_BC7_SRGB));
    EXPECT_EQ(Utility::GetComponentCount(B10G11R11_UFloatPack32), 3u);
}

TEST(GraphicsFormatUtility, TellsKinds)
{
    EXPECT_TRUE(Utility::IsDepthFormat(D24_UNorm) && !Utility::IsDepthFormat(S8_UInt));
    EXPECT_TRUE(Utility::IsStencilFormat(S8_UInt) && !Utility::IsStencilFormat(D32_SFloat));
    EXPECT_TRUE(Utility::IsDepthStencilFormat(S8_UInt) && Utility::IsDepthStencilFormat(D16_UNorm));
    EXPECT_FALSE(Utility::IsDepthStencilFormat(R8_UInt));
    EXPECT_EQ(Utility::GetDepthBits(D24_UNorm_S8_UInt), 24);
    EXPECT_EQ(Utility::GetDepthBits(S8_UInt), 0);
    EXPECT_TRUE(Utility::IsHalfFormat(R16G16_SFloat) && !Utility::IsHalfFormat(R32_SFloat));
    EXPECT_TRUE(Utility::IsFloatFormat(R32_SFloat) && Utility::IsIEEE754Format(R16_SFloat));
    EXPECT_FALSE(Utility::IsIEEE754Format(B10G11R11_UFloatPack32));
    EXPECT_TRUE(Utility::IsIntegerFormat(R8_SInt) && Utility::IsUIntFormat(R32G32_UInt));
    EXPECT_FALSE(Utility::IsUIntFormat(D32_SFloat_S8_UInt));
    EXPECT_TRUE(Utility::IsSNormFormat(R16G16_SNorm) && Utility::IsSignedFormat(R16G16_SNorm));
    EXPECT_TRUE(Utility::IsNormFormat(R8_UNorm) && !Utility::IsSignedFormat(R8_UNorm));
    EXPECT_TRUE(Utility::IsPackedFormat(R5G6B5_UNormPack16) && !Utility::IsPackedFormat(R8_UNorm));
    EXPECT_EQ(Utility::GetFormatString(R16G16_SNorm), "R16G16_SNorm");
}

TEST(GraphicsFormatUtility, FindsTheOlderName)
{
    EXPECT_EQ(Utility::GetRenderTextureFormat(R8G8B8A8_SRGB), RenderTextureFormat::ARGB32);
    EXPECT_EQ(Utility::GetRenderTextureFormat(R16G16_SFloat), RenderTextureFormat::RGHalf);
    EXPECT_EQ(Utility::GetRenderTextureFormat(D24_UNorm_S8_UInt), RenderTextureFormat::Depth);
    EXPECT_EQ(Utility::GetRenderTextureFormat(R8_SInt), RenderTextureFormat::Default);
    EXPECT_EQ(
        Utility::GetGraphicsFormat(RenderTextureFormat::ARGB32, RenderTextureReadWrite::Linear),
        R8G8B8A8_UNorm);
    EXPECT_EQ(
        Utility::GetGraphicsFormat(RenderTextureFormat::ARGB32, RenderTextureReadWrite::Default),
        R8G8B8A8_SRGB);
}

TEST(GraphicsFormatUtility, RefusesBitsThatNoDepthHas)
{
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([] { Utility::GetDepthStencilFormat(64, 0); }),
        test::Mentions("GetDepthStencilFormat", "64 bits", "0 of stencil", "0 to 32", "0 to 8"));
}

} // namespace limn
