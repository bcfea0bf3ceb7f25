#include "texture/PickyDevice.h"

#include <gtest/gtest.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/SystemInfo.h>

namespace limn
{
namespace
{

TEST(SystemInfo, HasUnitysNumbersOfUsages)
{
    EXPECT_EQ(static_cast<int>(FormatUsage::Render), 4);
    EXPECT_EQ(static_cast<int>(FormatUsage::Blend), 5);
    EXPECT_EQ(static_cast<int>(FormatUsage::LoadStore), 10);
    EXPECT_EQ(static_cast<int>(FormatUsage::StencilSampling), 16);
}

TEST(SystemInfo, AsksTheDeviceThatWasMadeLast)
{
    using RenderingUtils::SupportsRenderTextureFormat;
    // Without one: what the specification promises of all.
    EXPECT_TRUE(SupportsRenderTextureFormat(RenderTextureFormat::ARGBHalf));
    EXPECT_TRUE(SupportsRenderTextureFormat(RenderTextureFormat::R8));
    EXPECT_TRUE(SupportsRenderTextureFormat(RenderTextureFormat::Depth));
    EXPECT_FALSE(SupportsRenderTextureFormat(RenderTextureFormat::RG32));
    {
        const test::PickyDevice device(GraphicsFormat::R16G16_UNorm);
        EXPECT_TRUE(SupportsRenderTextureFormat(RenderTextureFormat::RG32));
        EXPECT_FALSE(SupportsRenderTextureFormat(RenderTextureFormat::R8));
        const test::PickyDevice later(GraphicsFormat::R8_UNorm);
        EXPECT_FALSE(SupportsRenderTextureFormat(RenderTextureFormat::RG32));
        EXPECT_TRUE(
            RenderingUtils::SupportsGraphicsFormat(GraphicsFormat::R8_UNorm, FormatUsage::Linear));
    }
    EXPECT_TRUE(SupportsRenderTextureFormat(RenderTextureFormat::ARGBHalf)) << "both are gone";
}

// Vulkan 1.3, 34.5: rows of the tables of mandatory formats.
TEST(SystemInfo, KnowsWhatEveryDeviceDoes)
{
    using enum GraphicsFormat;
    EXPECT_TRUE(EveryDeviceSupports(R16_SFloat, FormatUsage::Blend));
    EXPECT_TRUE(EveryDeviceSupports(R32_SFloat, FormatUsage::Render));
    EXPECT_FALSE(EveryDeviceSupports(R32_SFloat, FormatUsage::Blend));
    EXPECT_FALSE(EveryDeviceSupports(R32G32B32A32_SFloat, FormatUsage::Linear));
    EXPECT_TRUE(EveryDeviceSupports(B10G11R11_UFloatPack32, FormatUsage::Linear));
    EXPECT_FALSE(EveryDeviceSupports(B10G11R11_UFloatPack32, FormatUsage::Render));
    EXPECT_TRUE(EveryDeviceSupports(A2B10G10R10_UNormPack32, FormatUsage::Blend));
    EXPECT_TRUE(EveryDeviceSupports(R8G8B8A8_SNorm, FormatUsage::LoadStore));
    EXPECT_FALSE(EveryDeviceSupports(R8G8B8A8_SRGB, FormatUsage::LoadStore));
    EXPECT_TRUE(EveryDeviceSupports(R32_UInt, FormatUsage::Render));
    EXPECT_FALSE(EveryDeviceSupports(R32_UInt, FormatUsage::Blend));
    EXPECT_FALSE(EveryDeviceSupports(R32_UInt, FormatUsage::MSAA4x));
    EXPECT_TRUE(EveryDeviceSupports(R8G8B8A8_UNorm, FormatUsage::MSAA4x));
    EXPECT_FALSE(EveryDeviceSupports(R8G8B8A8_UNorm, FormatUsage::Sparse));
    EXPECT_FALSE(EveryDeviceSupports(None, FormatUsage::Sample));
    EXPECT_FALSE(EveryDeviceSupports(R16G16_SNorm, FormatUsage::Render));
    EXPECT_TRUE(EveryDeviceSupports(R8G8_SInt, FormatUsage::Render));
    EXPECT_FALSE(EveryDeviceSupports(R8G8_SInt, FormatUsage::Linear));
    EXPECT_TRUE(EveryDeviceSupports(E5B9G9R9_UFloatPack32, FormatUsage::Linear));
    EXPECT_FALSE(EveryDeviceSupports(R8G8B8_UNorm, FormatUsage::Sample));
    EXPECT_TRUE(EveryDeviceSupports(D24_UNorm_S8_UInt, FormatUsage::Render)) << "of 32 bits";
}

TEST(SystemInfo, AsksForAllOfSeveralUsages)
{
    using enum GraphicsFormat;
    using Usage = GraphicsFormatUsage;
    EXPECT_TRUE(SystemInfo::IsFormatSupported(R32_SFloat, Usage::Render | Usage::Sample));
    EXPECT_FALSE(SystemInfo::IsFormatSupported(R32_SFloat, Usage::Render | Usage::Blend));
    EXPECT_FALSE(SystemInfo::IsFormatSupported(RGBA_BC7_UNorm, Usage::Sample));
    EXPECT_FALSE(SystemInfo::IsFormatSupported(None, Usage::None));
    EXPECT_TRUE(SystemInfo::SupportsTextureFormat(TextureFormat::RGBA32));
    EXPECT_FALSE(SystemInfo::SupportsTextureFormat(TextureFormat::ARGB32));
    EXPECT_TRUE(SystemInfo::SupportsRandomWriteOnRenderTextureFormat(RenderTextureFormat::RFloat));
    EXPECT_FALSE(SystemInfo::SupportsBlendingOnRenderTextureFormat(RenderTextureFormat::RFloat));
}

TEST(SystemInfo, FindsAFormatThatDoes)
{
    using enum GraphicsFormat;
    EXPECT_EQ(SystemInfo::GetCompatibleFormat(R8_UNorm, FormatUsage::Render), R8_UNorm);
    EXPECT_EQ(SystemInfo::GetCompatibleFormat(R8G8_SNorm, FormatUsage::Render),
              R16G16B16A16_SFloat);
    EXPECT_EQ(SystemInfo::GetCompatibleFormat(R16G16_SNorm, FormatUsage::Render),
              R32G32B32A32_SFloat)
        << "a half has 11 bits only";
    EXPECT_EQ(SystemInfo::GetCompatibleFormat(R8G8B8_SRGB, FormatUsage::Sample), R8G8B8A8_SRGB);
    EXPECT_EQ(SystemInfo::GetCompatibleFormat(R8G8B8_UInt, GraphicsFormatUsage::Render),
              R32G32B32A32_UInt);
    EXPECT_EQ(SystemInfo::GetCompatibleFormat(R8_UNorm, FormatUsage::Sparse), None);
    EXPECT_EQ(SystemInfo::GetGraphicsFormat(DefaultFormat::HDR), R16G16B16A16_SFloat);
}

} // namespace
} // namespace limn
