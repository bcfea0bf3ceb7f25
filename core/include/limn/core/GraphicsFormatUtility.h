#pragma once

#include <cstdint>
#include <limn/core/GraphicsFormat.h>

namespace limn
{

/// Questions about formats. Where Unity's answer depends on the platform, it is the one of what
/// limn makes. Unity: UnityEngine.Experimental.Rendering.GraphicsFormatUtility (2022.3).
namespace GraphicsFormatUtility
{

inline GraphicsFormat GetGraphicsFormat(RenderTextureFormat format, bool isSRGB)
{
    return ToGraphicsFormat(format, isSRGB);
}
inline GraphicsFormat GetGraphicsFormat(RenderTextureFormat format,
                                        RenderTextureReadWrite readWrite)
{
    return ToGraphicsFormat(format, readWrite != RenderTextureReadWrite::Linear);
}
/// None for TextureFormat::ARGB32 and ARGB4444.
inline GraphicsFormat GetGraphicsFormat(TextureFormat format, bool isSRGB)
{
    return ToGraphicsFormat(format, isSRGB);
}
/// The older name that stands for the format or its sRGB-encoded pair; Default where there is none.
RenderTextureFormat GetRenderTextureFormat(GraphicsFormat format);
/// The one of Unity's two numbers that has so many bits of both at least; None for no bits.
/// @throws ContractError for negative numbers, more than 32 bits of depth or 8 of stencil
GraphicsFormat GetDepthStencilFormat(int minimumDepthBits, int minimumStencilBits);
/// The same with a stencil for more than 16 bits, as RenderTextureDescriptor::depthBufferBits.
GraphicsFormat GetDepthStencilFormat(int minimumDepthBits);
int GetDepthBits(GraphicsFormat format); ///< that the format's name says; 0 for others

/// The pair of a format with or without sRGB-encoded texels; itself where it has none.
GraphicsFormat GetSRGBFormat(GraphicsFormat format);
GraphicsFormat GetLinearFormat(GraphicsFormat format);

/// Unity's spelling.
inline std::string GetFormatString(GraphicsFormat format)
{
    return ToString(format);
}

/// Components of a texel of any format, a compressed one's too; depth and stencil are none.
std::uint32_t GetComponentCount(GraphicsFormat format);
std::uint32_t GetColorComponentCount(GraphicsFormat format); ///< without alpha
std::uint32_t GetAlphaComponentCount(GraphicsFormat format); ///< 0 or 1
bool HasAlphaChannel(GraphicsFormat format);

// Texels a side and bytes of a block; of what is not compressed, of one texel.
std::uint32_t GetBlockWidth(GraphicsFormat format);
std::uint32_t GetBlockHeight(GraphicsFormat format);
/// @throws ContractError for None and formats that leave the choice to Unity
std::uint32_t GetBlockSize(GraphicsFormat format);
/// Bytes of a picture of that format, in whole blocks.
std::uint32_t ComputeMipmapSize(int width, int height, GraphicsFormat format);

bool IsDepthFormat(GraphicsFormat format);        ///< it has a depth
bool IsStencilFormat(GraphicsFormat format);      ///< it has a stencil
bool IsDepthStencilFormat(GraphicsFormat format); ///< it has one of both
inline bool IsSRGBFormat(GraphicsFormat format)
{
    return limn::IsSRGBFormat(format);
}
bool IsCompressedFormat(GraphicsFormat format);
bool IsPackedFormat(GraphicsFormat format); ///< several components share bytes
bool IsHalfFormat(GraphicsFormat format);
bool IsFloatFormat(GraphicsFormat format);   ///< of 32 bits a component
bool IsIEEE754Format(GraphicsFormat format); ///< one of these two
bool IsIntegerFormat(GraphicsFormat format);
bool IsUIntFormat(GraphicsFormat format);
bool IsSIntFormat(GraphicsFormat format);
bool IsNormFormat(GraphicsFormat format);
bool IsUNormFormat(GraphicsFormat format);
bool IsSNormFormat(GraphicsFormat format);
bool IsSignedFormat(GraphicsFormat format); ///< components may be negative

} // namespace GraphicsFormatUtility

} // namespace limn
