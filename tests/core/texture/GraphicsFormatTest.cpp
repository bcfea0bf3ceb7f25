#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <limn/core/GraphicsFormatUtility.h>
#include <limn/core/RenderTexture.h>
#include <set>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

using enum GraphicsFormat;

struct FormatFact
{
    GraphicsFormat format;
    const char* name;
    int unityValue;
    int bytes; ///< of a texel; grouped by hand
};

// All that textures can be of. Unity's numbers are those of its documentation.
const FormatFact k_Facts[] = {
    {R8_SRGB, "R8_SRGB", 1, 1},
    {R8G8_SRGB, "R8G8_SRGB", 2, 2},
    {R8G8B8_SRGB, "R8G8B8_SRGB", 3, 3},
    {R8G8B8A8_SRGB, "R8G8B8A8_SRGB", 4, 4},
    {R8_UNorm, "R8_UNorm", 5, 1},
    {R8G8_UNorm, "R8G8_UNorm", 6, 2},
    {R8G8B8_UNorm, "R8G8B8_UNorm", 7, 3},
    {R8G8B8A8_UNorm, "R8G8B8A8_UNorm", 8, 4},
    {R8_SNorm, "R8_SNorm", 9, 1},
    {R8G8_SNorm, "R8G8_SNorm", 10, 2},
    {R8G8B8_SNorm, "R8G8B8_SNorm", 11, 3},
    {R8G8B8A8_SNorm, "R8G8B8A8_SNorm", 12, 4},
    {R8_UInt, "R8_UInt", 13, 1},
    {R8G8_UInt, "R8G8_UInt", 14, 2},
    {R8G8B8_UInt, "R8G8B8_UInt", 15, 3},
    {R8G8B8A8_UInt, "R8G8B8A8_UInt", 16, 4},
    {R8_SInt, "R8_SInt", 17, 1},
    {R8G8_SInt, "R8G8_SInt", 18, 2},
    {R8G8B8_SInt, "R8G8B8_SInt", 19, 3},
    {R8G8B8A8_SInt, "R8G8B8A8_SInt", 20, 4},
    {R16_UNorm, "R16_UNorm", 21, 2},
    {R16G16_UNorm, "R16G16_UNorm", 22, 4},
    {R16G16B16_UNorm, "R16G16B16_UNorm", 23, 6},
    {R16G16B16A16_UNorm, "R16G16B16A16_UNorm", 24, 8},
    {R16_SNorm, "R16_SNorm", 25, 2},
    {R16G16_SNorm, "R16G16_SNorm", 26, 4},
    {R16G16B16_SNorm, "R16G16B16_SNorm", 27, 6},
    {R16G16B16A16_SNorm, "R16G16B16A16_SNorm", 28, 8},
    {R16_UInt, "R16_UInt", 29, 2},
    {R16G16_UInt, "R16G16_UInt", 30, 4},
    {R16G16B16_UInt, "R16G16B16_UInt", 31, 6},
    {R16G16B16A16_UInt, "R16G16B16A16_UInt", 32, 8},
    {R16_SInt, "R16_SInt", 33, 2},
    {R16G16_SInt, "R16G16_SInt", 34, 4},
    {R16G16B16_SInt, "R16G16B16_SInt", 35, 6},
    {R16G16B16A16_SInt, "R16G16B16A16_SInt", 36, 8},
    {R32_UInt, "R32_UInt", 37, 4},
    {R32G32_UInt, "R32G32_UInt", 38, 8},
    {R32G32B32_UInt, "R32G32B32_UInt", 39, 12},
    {R32G32B32A32_UInt, "R32G32B32A32_UInt", 40, 16},
    {R32_SInt, "R32_SInt", 41, 4},
    {R32G32_SInt, "R32G32_SInt", 42, 8},
    {R32G32B32_SInt, "R32G32B32_SInt", 43, 12},
    {R32G32B32A32_SInt, "R32G32B32A32_SInt", 44, 16},
    {R16_SFloat, "R16_SFloat", 45, 2},
    {R16G16_SFloat, "R16G16_SFloat", 46, 4},
    {R16G16B16_SFloat, "R16G16B16_SFloat", 47, 6},
    {R16G16B16A16_SFloat, "R16G16B16A16_SFloat", 48, 8},
    {R32_SFloat, "R32_SFloat", 49, 4},
    {R32G32_SFloat, "R32G32_SFloat", 50, 8},
    {R32G32B32_SFloat, "R32G32B32_SFloat", 51, 12},
    {R32G32B32A32_SFloat, "R32G32B32A32_SFloat", 52, 16},
    {B8G8R8_SRGB, "B8G8R8_SRGB", 56, 3},
    {B8G8R8A8_SRGB, "B8G8R8A8_SRGB", 57, 4},
    {B8G8R8_UNorm, "B8G8R8_UNorm", 58, 3},
    {B8G8R8A8_UNorm, "B8G8R8A8_UNorm", 59, 4},
    {B8G8R8_SNorm, "B8G8R8_SNorm", 60, 3},
    {B8G8R8A8_SNorm, "B8G8R8A8_SNorm", 61, 4},
    {B8G8R8_UInt, "B8G8R8_UInt", 62, 3},
    {B8G8R8A8_UInt, "B8G8R8A8_UInt", 63, 4},
    {B8G8R8_SInt, "B8G8R8_SInt", 64, 3},
    {B8G8R8A8_SInt, "B8G8R8A8_SInt", 65, 4},
    {R4G4B4A4_UNormPack16, "R4G4B4A4_UNormPack16", 66, 2},
    {B4G4R4A4_UNormPack16, "B4G4R4A4_UNormPack16", 67, 2},
    {R5G6B5_UNormPack16, "R5G6B5_UNormPack16", 68, 2},
    {B5G6R5_UNormPack16, "B5G6R5_UNormPack16", 69, 2},
    {R5G5B5A1_UNormPack16, "R5G5B5A1_UNormPack16", 70, 2},
    {B5G5R5A1_UNormPack16, "B5G5R5A1_UNormPack16", 71, 2},
    {A1R5G5B5_UNormPack16, "A1R5G5B5_UNormPack16", 72, 2},
    {E5B9G9R9_UFloatPack32, "E5B9G9R9_UFloatPack32", 73, 4},
    {B10G11R11_UFloatPack32, "B10G11R11_UFloatPack32", 74, 4},
    {A2B10G10R10_UNormPack32, "A2B10G10R10_UNormPack32", 75, 4},
    {A2B10G10R10_UIntPack32, "A2B10G10R10_UIntPack32", 76, 4},
    {A2B10G10R10_SIntPack32, "A2B10G10R10_SIntPack32", 77, 4},
    {A2R10G10B10_UNormPack32, "A2R10G10B10_UNormPack32", 78, 4},
    {A2R10G10B10_UIntPack32, "A2R10G10B10_UIntPack32", 79, 4},
    {A2R10G10B10_SIntPack32, "A2R10G10B10_SIntPack32", 80, 4},
    {D16_UNorm, "D16_UNorm", 90, 2},
    {D24_UNorm, "D24_UNorm", 91, 4},
    {D24_UNorm_S8_UInt, "D24_UNorm_S8_UInt", 92, 4},
    {D32_SFloat, "D32_SFloat", 93, 4},
    {D32_SFloat_S8_UInt, "D32_SFloat_S8_UInt", 94, 8},
    {S8_UInt, "S8_UInt", 95, 1},
    {D16_UNorm_S8_UInt, "D16_UNorm_S8_UInt", 151, 4},
};

// All others.
struct RefusedFact
{
    GraphicsFormat format;
    const char* name;
    int unityValue;
};
const RefusedFact k_Refused[] = {
    {A2R10G10B10_XRSRGBPack32, "A2R10G10B10_XRSRGBPack32", 81},
    {A2R10G10B10_XRUNormPack32, "A2R10G10B10_XRUNormPack32", 82},
    {R10G10B10_XRSRGBPack32, "R10G10B10_XRSRGBPack32", 83},
    {R10G10B10_XRUNormPack32, "R10G10B10_XRUNormPack32", 84},
    {A10R10G10B10_XRSRGBPack32, "A10R10G10B10_XRSRGBPack32", 85},
    {A10R10G10B10_XRUNormPack32, "A10R10G10B10_XRUNormPack32", 86},
    {RGBA_DXT1_SRGB, "RGBA_DXT1_SRGB", 96},
    {RGBA_DXT1_UNorm, "RGBA_DXT1_UNorm", 97},
    {RGBA_DXT3_SRGB, "RGBA_DXT3_SRGB", 98},
    {RGBA_DXT3_UNorm, "RGBA_DXT3_UNorm", 99},
    {RGBA_DXT5_SRGB, "RGBA_DXT5_SRGB", 100},
    {RGBA_DXT5_UNorm, "RGBA_DXT5_UNorm", 101},
    {R_BC4_UNorm, "R_BC4_UNorm", 102},
    {R_BC4_SNorm, "R_BC4_SNorm", 103},
    {RG_BC5_UNorm, "RG_BC5_UNorm", 104},
    {RG_BC5_SNorm, "RG_BC5_SNorm", 105},
    {RGB_BC6H_UFloat, "RGB_BC6H_UFloat", 106},
    {RGB_BC6H_SFloat, "RGB_BC6H_SFloat", 107},
    {RGBA_BC7_SRGB, "RGBA_BC7_SRGB", 108},
    {RGBA_BC7_UNorm, "RGBA_BC7_UNorm", 109},
    {RGB_PVRTC_2Bpp_SRGB, "RGB_PVRTC_2Bpp_SRGB", 110},
    {RGB_PVRTC_2Bpp_UNorm, "RGB_PVRTC_2Bpp_UNorm", 111},
    {RGB_PVRTC_4Bpp_SRGB, "RGB_PVRTC_4Bpp_SRGB", 112},
    {RGB_PVRTC_4Bpp_UNorm, "RGB_PVRTC_4Bpp_UNorm", 113},
    {RGBA_PVRTC_2Bpp_SRGB, "RGBA_PVRTC_2Bpp_SRGB", 114},
    {RGBA_PVRTC_2Bpp_UNorm, "RGBA_PVRTC_2Bpp_UNorm", 115},
    {RGBA_PVRTC_4Bpp_SRGB, "RGBA_PVRTC_4Bpp_SRGB", 116},
    {RGBA_PVRTC_4Bpp_UNorm, "RGBA_PVRTC_4Bpp_UNorm", 117},
    {RGB_ETC_UNorm, "RGB_ETC_UNorm", 118},
    {RGB_ETC2_SRGB, "RGB_ETC2_SRGB", 119},
    {RGB_ETC2_UNorm, "RGB_ETC2_UNorm", 120},
    {RGB_A1_ETC2_SRGB, "RGB_A1_ETC2_SRGB", 121},
    {RGB_A1_ETC2_UNorm, "RGB_A1_ETC2_UNorm", 122},
    {RGBA_ETC2_SRGB, "RGBA_ETC2_SRGB", 123},
    {RGBA_ETC2_UNorm, "RGBA_ETC2_UNorm", 124},
    {R_EAC_UNorm, "R_EAC_UNorm", 125},
    {R_EAC_SNorm, "R_EAC_SNorm", 126},
    {RG_EAC_UNorm, "RG_EAC_UNorm", 127},
    {RG_EAC_SNorm, "RG_EAC_SNorm", 128},
    {RGBA_ASTC4X4_SRGB, "RGBA_ASTC4X4_SRGB", 129},
    {RGBA_ASTC4X4_UNorm, "RGBA_ASTC4X4_UNorm", 130},
    {RGBA_ASTC5X5_SRGB, "RGBA_ASTC5X5_SRGB", 131},
    {RGBA_ASTC5X5_UNorm, "RGBA_ASTC5X5_UNorm", 132},
    {RGBA_ASTC6X6_SRGB, "RGBA_ASTC6X6_SRGB", 133},
    {RGBA_ASTC6X6_UNorm, "RGBA_ASTC6X6_UNorm", 134},
    {RGBA_ASTC8X8_SRGB, "RGBA_ASTC8X8_SRGB", 135},
    {RGBA_ASTC8X8_UNorm, "RGBA_ASTC8X8_UNorm", 136},
    {RGBA_ASTC10X10_SRGB, "RGBA_ASTC10X10_SRGB", 137},
    {RGBA_ASTC10X10_UNorm, "RGBA_ASTC10X10_UNorm", 138},
    {RGBA_ASTC12X12_SRGB, "RGBA_ASTC12X12_SRGB", 139},
    {RGBA_ASTC12X12_UNorm, "RGBA_ASTC12X12_UNorm", 140},
    {YUV2, "YUV2", 141},
    {DepthAuto, "DepthAuto", 142},
    {ShadowAuto, "ShadowAuto", 143},
    {VideoAuto, "VideoAuto", 144},
    {RGBA_ASTC4X4_UFloat, "RGBA_ASTC4X4_UFloat", 145},
    {RGBA_ASTC5X5_UFloat, "RGBA_ASTC5X5_UFloat", 146},
    {RGBA_ASTC6X6_UFloat, "RGBA_ASTC6X6_UFloat", 147},
    {RGBA_ASTC8X8_UFloat, "RGBA_ASTC8X8_UFloat", 148},
    {RGBA_ASTC10X10_UFloat, "RGBA_ASTC10X10_UFloat", 149},
    {RGBA_ASTC12X12_UFloat, "RGBA_ASTC12X12_UFloat", 150},
};

} // namespace

TEST(GraphicsFormat, HasUnitysNamesAndNumbers)
{
    std::set<int> values;
    for (const FormatFact& fact : k_Facts)
    {
        EXPECT_STREQ(ToString(fact.format), fact.name);
        EXPECT_EQ(static_cast<int>(fact.format), fact.unityValue) << fact.name;
        values.insert(fact.unityValue);
    }
    for (const RefusedFact& fact : k_Refused)
    {
        EXPECT_STREQ(ToString(fact.format), fact.name);
        EXPECT_EQ(static_cast<int>(fact.format), fact.unityValue) << fact.name;
        values.insert(fact.unityValue);
    }
    EXPECT_STREQ(ToString(None), "None");
    EXPECT_EQ(RGB_DXT1_SRGB, RGBA_DXT1_SRGB);
    EXPECT_EQ(RGB_DXT1_UNorm, RGBA_DXT1_UNorm);
    EXPECT_EQ(values.size(), std::size(k_Facts) + std::size(k_Refused))
        << "a number is given twice";
    EXPECT_EQ(values.size(), 151u - 3u - 3u) << "1 to 151, of which 53 to 55 and 87 to 89 are none";
}

TEST(GraphicsFormat, KnowsTheSizeOfATexel)
{
    for (const FormatFact& fact : k_Facts)
    {
        EXPECT_EQ(BytesPerTexel(fact.format), fact.bytes) << fact.name;
        EXPECT_EQ(GraphicsFormatUtility::GetBlockSize(fact.format),
                  static_cast<std::uint32_t>(fact.bytes))
            << fact.name;
    }
}

TEST(GraphicsFormat, HasNoTexelsWhereThereAreNone)
{
    EXPECT_THAT(test::ThrownMessage<ContractError>([] { BytesPerTexel(None); }),
                test::Mentions("GraphicsFormat None", "no texels"));
    EXPECT_THAT(test::ThrownMessage<ContractError>([] { BytesPerTexel(RGBA_BC7_SRGB); }),
                test::Mentions("RGBA_BC7_SRGB", "compressed", "R8G8B8A8_SRGB"));
}

TEST(GraphicsFormat, CallsThoseWithADInFrontOrAStencilDepth)
{
    for (const FormatFact& fact : k_Facts)
    {
        const std::string_view name = fact.name;
        EXPECT_EQ(IsDepthFormat(fact.format), name[0] == 'D' || name[0] == 'S') << name;
        EXPECT_EQ(HasStencil(fact.format), name.find("S8") != name.npos) << name;
    }
}

TEST(GraphicsFormat, IsMadeOrRefusedWithAnotherThatWouldDo)
{
    for (const FormatFact& fact : k_Facts)
    {
        const RenderTexture texture("T", RenderTextureDescriptor(4, 4, fact.format));
        const bool isKept = fact.name[0] != 'D' && fact.name[0] != 'S';
        EXPECT_TRUE(!isKept || texture.graphicsFormat() == fact.format) << fact.name;
    }
    for (const RefusedFact& fact : k_Refused)
    {
        const std::string message = test::ThrownMessage<ContractError>(
            [&] { const RenderTexture texture("T", RenderTextureDescriptor(4, 4, fact.format)); });
        EXPECT_THAT(message,
                    testing::StartsWith("texture 'T': the format " + std::string(fact.name)));
        EXPECT_THAT(message, testing::EndsWith(" would do"));
    }
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [] {
                        const RenderTexture texture("T", {4, 4, R_BC4_SNorm});
                    }),
                test::Mentions("'T'", "R_BC4_SNorm", "compressed", "R8_SNorm"));
}

TEST(GraphicsFormat, TellsTheComponentsOfATexel)
{
    EXPECT_EQ(ChannelCount(R5G6B5_UNormPack16), 3);
    EXPECT_EQ(ChannelCount(B5G5R5A1_UNormPack16), 4);
    EXPECT_EQ(ChannelCount(E5B9G9R9_UFloatPack32), 3);
    EXPECT_EQ(ChannelCount(R16G16_SNorm), 2);
    EXPECT_EQ(ComponentType(R8G8_SInt), UniformType::Int);
    EXPECT_EQ(ComponentType(A2B10G10R10_UIntPack32), UniformType::UInt);
    EXPECT_EQ(ComponentType(R16G16_SNorm), UniformType::Float);
}

TEST(GraphicsFormat, StandsForEachOlderName)
{
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::ARGB32), R8G8B8A8_UNorm);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::ARGB32, true), R8G8B8A8_SRGB);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::Depth), D32_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::ARGBHalf), R16G16B16A16_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::ARGBFloat), R32G32B32A32_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::RGFloat), R32G32_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::RGHalf), R16G16_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::RFloat), R32_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::RHalf), R16_SFloat);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::R8), R8_UNorm);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::RGB111110Float), B10G11R11_UFloatPack32);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::RGB565), B5G6R5_UNormPack16);
    EXPECT_EQ(ToGraphicsFormat(RenderTextureFormat::ARGB1555), B5G5R5A1_UNormPack16);
    EXPECT_EQ(ToGraphicsFormat(TextureFormat::RGBA32, true), R8G8B8A8_SRGB);
    EXPECT_EQ(ToGraphicsFormat(TextureFormat::RGBAHalf, true), R16G16B16A16_SFloat);
    EXPECT_EQ(ToGraphicsFormat(TextureFormat::ARGB32, true), None);
}

} // namespace limn
