#pragma once

#include <limn/shaderlab/ShaderProgram.h>

namespace limn
{

/// Texel formats; values are Unity's. Unity: UnityEngine.Experimental.Rendering.GraphicsFormat.
enum class GraphicsFormat
{
    None = 0,
    R8G8B8A8_SRGB = 4,
    R8_UNorm = 5,
    R8G8_UNorm = 6,
    R8G8B8A8_UNorm = 8,
    R8G8B8A8_SNorm = 12,
    R8_UInt = 13,
    R8G8B8A8_UInt = 16,
    R16_UNorm = 21,
    R16G16_UNorm = 22,
    R16G16B16A16_UNorm = 24,
    R16_UInt = 29,
    R16G16B16A16_UInt = 32,
    R32_UInt = 37,
    R32G32_UInt = 38,
    R32G32B32A32_UInt = 40,
    R32_SInt = 41,
    R32G32_SInt = 42,
    R32G32B32A32_SInt = 44,
    R16_SFloat = 45,
    R16G16_SFloat = 46,
    R16G16B16A16_SFloat = 48,
    R32_SFloat = 49,
    R32G32_SFloat = 50,
    R32G32B32A32_SFloat = 52,
    B8G8R8A8_SRGB = 57,
    B8G8R8A8_UNorm = 59,
    B10G11R11_UFloatPack32 = 74,
    A2B10G10R10_UNormPack32 = 75,
    D32_SFloat = 93,
    D32_SFloat_S8_UInt = 94
};

/// The older names, as render features still write them. Unity: UnityEngine.RenderTextureFormat.
enum class RenderTextureFormat
{
    ARGB32 = 0,
    Depth = 1,
    ARGBHalf = 2,
    Shadowmap = 3, ///< Depth; RenderTextureDescriptor::shadowSamplingMode makes samplers compare
    Default = 7,   ///< ARGB32
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
    R16 = 28
};

/// Whether ARGB32 texels are sRGB-encoded; other formats never are.
/// Unity: UnityEngine.RenderTextureReadWrite.
enum class RenderTextureReadWrite
{
    Default = 0, ///< they are: the project's colour space is Linear
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

/// The format an older name stands for; ARGB32 and BGRA32 are sRGB-encoded only where `sRGB` says
/// so, Depth is D32_SFloat.
GraphicsFormat ToGraphicsFormat(RenderTextureFormat format, bool sRGB = false);

/// Bytes of one texel in memory; D32_SFloat_S8_UInt takes 8.
/// @throws ContractError for None
int BytesPerTexel(GraphicsFormat format);

/// How many components a texel has, 1...4; depth and stencil are one each.
/// @throws ContractError for None
int ChannelCount(GraphicsFormat format);

constexpr bool IsDepthFormat(GraphicsFormat format)
{
    return format == GraphicsFormat::D32_SFloat || format == GraphicsFormat::D32_SFloat_S8_UInt;
}

/// Unity: GraphicsFormatUtility.IsSRGBFormat.
constexpr bool IsSRGBFormat(GraphicsFormat format)
{
    return format == GraphicsFormat::R8G8B8A8_SRGB || format == GraphicsFormat::B8G8R8A8_SRGB;
}

/// What shaders have to take a texel's components for. Texels of integers are neither filtered nor
/// blended; a clear writes the integers nearest to its colour's components.
/// @throws ContractError for None
UniformType ComponentType(GraphicsFormat format);

/// Whether the format holds a stencil beside the depth.
constexpr bool HasStencil(GraphicsFormat format)
{
    return format == GraphicsFormat::D32_SFloat_S8_UInt;
}

/// Unity's spelling, e.g. "R8_UNorm".
const char* ToString(GraphicsFormat format);

} // namespace limn
