#pragma once

#include <limn/shaderlab/ShaderProgram.h>
#include <string>

namespace limn
{

/// Texel formats with Unity's names and values. GraphicsFormatProblem returns why one of them
/// cannot be made. Unity: UnityEngine.Experimental.Rendering.GraphicsFormat (2022.3, and
/// D16_UNorm_S8_UInt of 6).
enum class GraphicsFormat
{
    None = 0,
    R8_SRGB = 1,
    R8G8_SRGB = 2,
    R8G8B8_SRGB = 3,
    R8G8B8A8_SRGB = 4,
    R8_UNorm = 5,
    R8G8_UNorm = 6,
    R8G8B8_UNorm = 7,
    R8G8B8A8_UNorm = 8,
    R8_SNorm = 9,
    R8G8_SNorm = 10,
    R8G8B8_SNorm = 11,
    R8G8B8A8_SNorm = 12,
    R8_UInt = 13,
    R8G8_UInt = 14,
    R8G8B8_UInt = 15,
    R8G8B8A8_UInt = 16,
    R8_SInt = 17,
    R8G8_SInt = 18,
    R8G8B8_SInt = 19,
    R8G8B8A8_SInt = 20,
    R16_UNorm = 21,
    R16G16_UNorm = 22,
    R16G16B16_UNorm = 23,
    R16G16B16A16_UNorm = 24,
    R16_SNorm = 25,
    R16G16_SNorm = 26,
    R16G16B16_SNorm = 27,
    R16G16B16A16_SNorm = 28,
    R16_UInt = 29,
    R16G16_UInt = 30,
    R16G16B16_UInt = 31,
    R16G16B16A16_UInt = 32,
    R16_SInt = 33,
    R16G16_SInt = 34,
    R16G16B16_SInt = 35,
    R16G16B16A16_SInt = 36,
    R32_UInt = 37,
    R32G32_UInt = 38,
    R32G32B32_UInt = 39,
    R32G32B32A32_UInt = 40,
    R32_SInt = 41,
    R32G32_SInt = 42,
    R32G32B32_SInt = 43,
    R32G32B32A32_SInt = 44,
    R16_SFloat = 45,
    R16G16_SFloat = 46,
    R16G16B16_SFloat = 47,
    R16G16B16A16_SFloat = 48,
    R32_SFloat = 49,
    R32G32_SFloat = 50,
    R32G32B32_SFloat = 51,
    R32G32B32A32_SFloat = 52,
    B8G8R8_SRGB = 56,
    B8G8R8A8_SRGB = 57,
    B8G8R8_UNorm = 58,
    B8G8R8A8_UNorm = 59,
    B8G8R8_SNorm = 60,
    B8G8R8A8_SNorm = 61,
    B8G8R8_UInt = 62,
    B8G8R8A8_UInt = 63,
    B8G8R8_SInt = 64,
    B8G8R8A8_SInt = 65,
    R4G4B4A4_UNormPack16 = 66,
    B4G4R4A4_UNormPack16 = 67,
    R5G6B5_UNormPack16 = 68,
    B5G6R5_UNormPack16 = 69,
    R5G5B5A1_UNormPack16 = 70,
    B5G5R5A1_UNormPack16 = 71,
    A1R5G5B5_UNormPack16 = 72,
    E5B9G9R9_UFloatPack32 = 73,
    B10G11R11_UFloatPack32 = 74,
    A2B10G10R10_UNormPack32 = 75,
    A2B10G10R10_UIntPack32 = 76,
    A2B10G10R10_SIntPack32 = 77,
    A2R10G10B10_UNormPack32 = 78,
    A2R10G10B10_UIntPack32 = 79,
    A2R10G10B10_SIntPack32 = 80,
    A2R10G10B10_XRSRGBPack32 = 81,
    A2R10G10B10_XRUNormPack32 = 82,
    R10G10B10_XRSRGBPack32 = 83,
    R10G10B10_XRUNormPack32 = 84,
    A10R10G10B10_XRSRGBPack32 = 85,
    A10R10G10B10_XRUNormPack32 = 86,
    D16_UNorm = 90,
    D24_UNorm = 91,
    D24_UNorm_S8_UInt = 92,
    D32_SFloat = 93,
    D32_SFloat_S8_UInt = 94,
    S8_UInt = 95,
    RGB_DXT1_SRGB = 96, ///< Unity has two names for it
    RGBA_DXT1_SRGB = 96,
    RGB_DXT1_UNorm = 97, ///< and for this one
    RGBA_DXT1_UNorm = 97,
    RGBA_DXT3_SRGB = 98,
    RGBA_DXT3_UNorm = 99,
    RGBA_DXT5_SRGB = 100,
    RGBA_DXT5_UNorm = 101,
    R_BC4_UNorm = 102,
    R_BC4_SNorm = 103,
    RG_BC5_UNorm = 104,
    RG_BC5_SNorm = 105,
    RGB_BC6H_UFloat = 106,
    RGB_BC6H_SFloat = 107,
    RGBA_BC7_SRGB = 108,
    RGBA_BC7_UNorm = 109,
    RGB_PVRTC_2Bpp_SRGB = 110,
    RGB_PVRTC_2Bpp_UNorm = 111,
    RGB_PVRTC_4Bpp_SRGB = 112,
    RGB_PVRTC_4Bpp_UNorm = 113,
    RGBA_PVRTC_2Bpp_SRGB = 114,
    RGBA_PVRTC_2Bpp_UNorm = 115,
    RGBA_PVRTC_4Bpp_SRGB = 116,
    RGBA_PVRTC_4Bpp_UNorm = 117,
    RGB_ETC_UNorm = 118,
    RGB_ETC2_SRGB = 119,
    RGB_ETC2_UNorm = 120,
    RGB_A1_ETC2_SRGB = 121,
    RGB_A1_ETC2_UNorm = 122,
    RGBA_ETC2_SRGB = 123,
    RGBA_ETC2_UNorm = 124,
    R_EAC_UNorm = 125,
    R_EAC_SNorm = 126,
    RG_EAC_UNorm = 127,
    RG_EAC_SNorm = 128,
    RGBA_ASTC4X4_SRGB = 129,
    RGBA_ASTC4X4_UNorm = 130,
    RGBA_ASTC5X5_SRGB = 131,
    RGBA_ASTC5X5_UNorm = 132,
    RGBA_ASTC6X6_SRGB = 133,
    RGBA_ASTC6X6_UNorm = 134,
    RGBA_ASTC8X8_SRGB = 135,
    RGBA_ASTC8X8_UNorm = 136,
    RGBA_ASTC10X10_SRGB = 137,
    RGBA_ASTC10X10_UNorm = 138,
    RGBA_ASTC12X12_SRGB = 139,
    RGBA_ASTC12X12_UNorm = 140,
    YUV2 = 141,
    DepthAuto = 142,
    ShadowAuto = 143,
    VideoAuto = 144,
    RGBA_ASTC4X4_UFloat = 145,
    RGBA_ASTC5X5_UFloat = 146,
    RGBA_ASTC6X6_UFloat = 147,
    RGBA_ASTC8X8_UFloat = 148,
    RGBA_ASTC10X10_UFloat = 149,
    RGBA_ASTC12X12_UFloat = 150,
    D16_UNorm_S8_UInt = 151
};

/// The older names of texel formats, which render features still use.
/// Unity: UnityEngine.RenderTextureFormat.
enum class RenderTextureFormat
{
    ARGB32 = 0,
    Depth = 1,
    ARGBHalf = 2,
    Shadowmap = 3, ///< Depth; RenderTextureDescriptor::shadowSamplingMode makes samplers compare
    RGB565 = 4,
    ARGB4444 = 5,
    ARGB1555 = 6,
    Default = 7, ///< ARGB32
    ARGB2101010 = 8,
    DefaultHDR = 9, ///< RGB111110Float
    ARGB64 = 10,
    ARGBFloat = 11,
    RGFloat = 12,
    RGHalf = 13,
    RFloat = 14,
    RHalf = 15,
    R8 = 16,
    ARGBInt = 17,
    RGInt = 18,
    RInt = 19,
    BGRA32 = 20,
    RGB111110Float = 22,
    RG32 = 23,
    RGBAUShort = 24,
    RG16 = 25,
    BGRA10101010_XR = 26, ///< not accepted, nor is the next one: there is no such picture
    BGR101010_XR = 27,    ///< not accepted
    R16 = 28
};

/// Names of the formats that textures are made of, with Unity's values.
/// Unity: UnityEngine.TextureFormat (2022.3).
enum class TextureFormat
{
    Alpha8 = 1,
    ARGB4444 = 2, ///< no GraphicsFormat has this order of components, nor that of ARGB32
    RGB24 = 3,
    RGBA32 = 4,
    ARGB32 = 5,
    RGB565 = 7,
    R16 = 9,
    DXT1 = 10,
    DXT5 = 12,
    RGBA4444 = 13,
    BGRA32 = 14,
    RHalf = 15,
    RGHalf = 16,
    RGBAHalf = 17,
    RFloat = 18,
    RGFloat = 19,
    RGBAFloat = 20,
    RGB9e5Float = 22,
    BC6H = 24,
    BC7 = 25,
    BC4 = 26,
    BC5 = 27,
    RG16 = 62,
    R8 = 63,
    RG32 = 72,
    RGB48 = 73,
    RGBA64 = 74
};

/// Selects whether ARGB32 texels are sRGB-encoded; other formats never are.
/// Unity: UnityEngine.RenderTextureReadWrite.
enum class RenderTextureReadWrite
{
    Default = 0, ///< sRGB-encoded, since the project's colour space is Linear
    Linear = 1,
    sRGB = 2
};

enum class FilterMode
{
    Point = 0,
    Bilinear = 1,
    Trilinear = 2
};

enum class TextureWrapMode
{
    Repeat = 0,
    Clamp = 1,
    Mirror = 2,
    MirrorOnce = 3
};

/// Returns the format that an older name stands for; ARGB32 and BGRA32 are sRGB-encoded only if
/// `sRGB` is true, Depth is D32_SFloat.
GraphicsFormat ToGraphicsFormat(RenderTextureFormat format, bool sRGB = false);
/// Returns the format that a texture's format stands for. With `sRGB`, those of 8 bits per
/// component that have a colour are sRGB-encoded, and compressed ones if there is such a format.
/// Returns None for the two that no GraphicsFormat stands for.
GraphicsFormat ToGraphicsFormat(TextureFormat format, bool sRGB);

/// Returns why no texture can be of this format, and which one would do: "is compressed;
/// R8G8B8A8_SRGB would do". Returns an empty string if one can; the device may still lack it, which
/// SystemInfo::IsFormatSupported tells.
std::string GraphicsFormatProblem(GraphicsFormat format);

/// Returns the format as which a depth texture of this format is made on every device: D32_SFloat,
/// or D32_SFloat_S8_UInt if it has a stencil. Any other format is returned as it is.
GraphicsFormat MadeFormat(GraphicsFormat format);

/// Returns the bytes of one texel in memory; D32_SFloat_S8_UInt takes 8.
/// @throws ContractError for None and formats that no texture can have
int BytesPerTexel(GraphicsFormat format);

/// Returns the number of components of a texel, 1...4; depth and stencil are one each.
/// @throws ContractError for None and formats that no texture can have
int ChannelCount(GraphicsFormat format);

/// Returns whether the format is bound as depth or stencil.
constexpr bool IsDepthFormat(GraphicsFormat format)
{
    return (format >= GraphicsFormat::D16_UNorm && format <= GraphicsFormat::S8_UInt) ||
           format == GraphicsFormat::D16_UNorm_S8_UInt;
}

/// Unity: GraphicsFormatUtility.IsSRGBFormat.
bool IsSRGBFormat(GraphicsFormat format);

/// Returns the type that shaders must use for a texel's components. Texels of integers are neither
/// filtered nor blended; a clear writes the integers nearest to its colour's components.
/// @throws ContractError for None and formats that no texture can have
UniformType ComponentType(GraphicsFormat format);

/// Returns whether the format has a stencil.
constexpr bool HasStencil(GraphicsFormat format)
{
    return format == GraphicsFormat::D24_UNorm_S8_UInt ||
           format == GraphicsFormat::D32_SFloat_S8_UInt || format == GraphicsFormat::S8_UInt ||
           format == GraphicsFormat::D16_UNorm_S8_UInt;
}

/// Returns Unity's spelling, e.g. "R8_UNorm".
const char* ToString(GraphicsFormat format);

} // namespace limn
