#include <gtest/gtest.h>
#include <limn/core/GraphicsFormat.h>
#include <limn/shaderlab/Diagnostic.h>

#include "ThrownMessage.h"

namespace limn
{
namespace
{

struct FormatFact
{
    GraphicsFormat format;
    const char* name;
    int unityValue;
    int bytes; ///< summed from the bits that the name states
};

const FormatFact k_Facts[] = {
    {GraphicsFormat::R8G8B8A8_SRGB, "R8G8B8A8_SRGB", 4, 4 * 1},
    {GraphicsFormat::R8_UNorm, "R8_UNorm", 5, 1},
    {GraphicsFormat::R8G8_UNorm, "R8G8_UNorm", 6, 2 * 1},
    {GraphicsFormat::R8G8B8A8_UNorm, "R8G8B8A8_UNorm", 8, 4 * 1},
    {GraphicsFormat::R8_UInt, "R8_UInt", 13, 1},
    {GraphicsFormat::R8G8B8A8_UInt, "R8G8B8A8_UInt", 16, 4 * 1},
    {GraphicsFormat::R16_UNorm, "R16_UNorm", 21, 2},
    {GraphicsFormat::R16_UInt, "R16_UInt", 29, 2},
    {GraphicsFormat::R16G16B16A16_UInt, "R16G16B16A16_UInt", 32, 4 * 2},
    {GraphicsFormat::R32_UInt, "R32_UInt", 37, 4},
    {GraphicsFormat::R32G32_UInt, "R32G32_UInt", 38, 2 * 4},
    {GraphicsFormat::R32G32B32A32_UInt, "R32G32B32A32_UInt", 40, 4 * 4},
    {GraphicsFormat::R32_SInt, "R32_SInt", 41, 4},
    {GraphicsFormat::R32G32_SInt, "R32G32_SInt", 42, 2 * 4},
    {GraphicsFormat::R32G32B32A32_SInt, "R32G32B32A32_SInt", 44, 4 * 4},
    {GraphicsFormat::B8G8R8A8_SRGB, "B8G8R8A8_SRGB", 57, 4 * 1},
    {GraphicsFormat::B8G8R8A8_UNorm, "B8G8R8A8_UNorm", 59, 4 * 1},
    {GraphicsFormat::A2B10G10R10_UNormPack32, "A2B10G10R10_UNormPack32", 75, (2 + 3 * 10) / 8},
    {GraphicsFormat::R8G8B8A8_SNorm, "R8G8B8A8_SNorm", 12, 4 * 1},
    {GraphicsFormat::R16G16_UNorm, "R16G16_UNorm", 22, 2 * 2},
    {GraphicsFormat::R16G16B16A16_UNorm, "R16G16B16A16_UNorm", 24, 4 * 2},
    {GraphicsFormat::R16_SFloat, "R16_SFloat", 45, 2},
    {GraphicsFormat::R16G16_SFloat, "R16G16_SFloat", 46, 2 * 2},
    {GraphicsFormat::R16G16B16A16_SFloat, "R16G16B16A16_SFloat", 48, 4 * 2},
    {GraphicsFormat::R32_SFloat, "R32_SFloat", 49, 4},
    {GraphicsFormat::R32G32_SFloat, "R32G32_SFloat", 50, 2 * 4},
    {GraphicsFormat::R32G32B32A32_SFloat, "R32G32B32A32_SFloat", 52, 4 * 4},
    {GraphicsFormat::B10G11R11_UFloatPack32, "B10G11R11_UFloatPack32", 74, (10 + 11 + 11) / 8},
    {GraphicsFormat::D32_SFloat, "D32_SFloat", 93, 4},
    {GraphicsFormat::D32_SFloat_S8_UInt, "D32_SFloat_S8_UInt", 94, 4 + 4},
};

TEST(GraphicsFormat, HasUnitysNamesAndNumbers)
{
    for (const FormatFact& fact : k_Facts)
    {
        EXPECT_STREQ(ToString(fact.format), fact.name);
        EXPECT_EQ(static_cast<int>(fact.format), fact.unityValue) << fact.name;
    }
    EXPECT_STREQ(ToString(GraphicsFormat::None), "None");
}

TEST(GraphicsFormat, KnowsTheSizeOfATexel)
{
    for (const FormatFact& fact : k_Facts)
    {
        EXPECT_EQ(BytesPerTexel(fact.format), fact.bytes) << fact.name;
    }
}

TEST(GraphicsFormat, NoneHasNoTexels)
{
    EXPECT_EQ(test::ThrownMessage<ContractError>([] { BytesPerTexel(GraphicsFormat::None); }),
              "GraphicsFormat None has no texels; a format that limn knows is needed");
}

TEST(GraphicsFormat, CallsOnlyTheTwoDepthFormatsDepth)
{
    for (const FormatFact& fact : k_Facts)
    {
        EXPECT_EQ(IsDepthFormat(fact.format), fact.name[0] == 'D') << fact.name;
    }
}

TEST(GraphicsFormat, StandsForEachOlderName)
{
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::ARGB32), GraphicsFormat::R8G8B8A8_UNorm);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::ARGB32, true), GraphicsFormat::R8G8B8A8_SRGB);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::Depth), GraphicsFormat::D32_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::ARGBHalf), GraphicsFormat::R16G16B16A16_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::ARGBFloat),
              GraphicsFormat::R32G32B32A32_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::RGFloat), GraphicsFormat::R32G32_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::RGHalf), GraphicsFormat::R16G16_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::RFloat), GraphicsFormat::R32_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::RHalf), GraphicsFormat::R16_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::R8), GraphicsFormat::R8_UNorm);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::RGB111110Float),
              GraphicsFormat::B10G11R11_UFloatPack32);
}

} // namespace
} // namespace limn
