#pragma once

#include <cstdint>
#include <limn/core/GraphicsFormat.h>

namespace limn
{

/// Questions about formats. If Unity's answer depends on the platform, the answer here is about
/// what limn makes. Unity: UnityEngine.Experimental.Rendering.GraphicsFormatUtility (2022.3).
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
/// Returns the format that a texture's format stands for; None for TextureFormat::ARGB32 and
/// ARGB4444.
inline GraphicsFormat GetGraphicsFormat(TextureFormat format, bool isSRGB)
{
    return ToGraphicsFormat(format, isSRGB);
}
/// Returns the older name that stands for the format or its sRGB-encoded pair; Default if there is
/// none.
RenderTextureFormat GetRenderTextureFormat(GraphicsFormat format);
/// Returns a format with at least this many bits of both: D32_SFloat, or D32_SFloat_S8_UInt if
/// there are bits of stencil; None for no bits.
/// @throws ContractError for negative numbers, more than 32 bits of depth or 8 of stencil
GraphicsFormat GetDepthStencilFormat(int minimumDepthBits, int minimumStencilBits);
/// Returns a depth-stencil format, with a stencil for more than 16 bits, as
/// RenderTextureDescriptor::depthBufferBits does.
GraphicsFormat GetDepthStencilFormat(int minimumDepthBits);
int GetDepthBits(GraphicsFormat format); ///< the bits in the format's name; 0 for other formats

/// Returns the pair of a format with or without sRGB-encoded texels, or the format itself if it has
/// none.
GraphicsFormat GetSRGBFormat(GraphicsFormat format);
GraphicsFormat GetLinearFormat(GraphicsFormat format);

/// Returns Unity's spelling of a format.
inline std::string GetFormatString(GraphicsFormat format)
{
    return ToString(format);
}

/// Returns the number of components of a texel of any format, also of a compressed one; depth and
/// stencil count as none.
std::uint32_t GetComponentCount(GraphicsFormat format);
std::uint32_t GetColorComponentCount(GraphicsFormat format); ///< without alpha
std::uint32_t GetAlphaComponentCount(GraphicsFormat format); ///< 0 or 1
bool HasAlphaChannel(GraphicsFormat format);

// These return the texels per side and the bytes of a block; for a format that is not compressed, a
// block is one texel.
std::uint32_t GetBlockWidth(GraphicsFormat format);
std::uint32_t GetBlockHeight(GraphicsFormat format);
/// @throws ContractError for None and formats that leave the choice to Unity
std::uint32_t GetBlockSize(GraphicsFormat format);
/// Returns the bytes of a picture of this format, in whole blocks.
std::uint32_t ComputeMipmapSize(int width, int height, GraphicsFormat format);

bool IsDepthFormat(GraphicsFormat format);        ///< it has a depth
bool IsStencilFormat(GraphicsFormat format);      ///< it has a stencil
bool IsDepthStencilFormat(GraphicsFormat format); ///< it has a depth and a stencil
inline bool IsSRGBFormat(GraphicsFormat format)
{
    return limn::IsSRGBFormat(format);
}
bool IsCompressedFormat(GraphicsFormat format);
bool IsPackedFormat(GraphicsFormat format); ///< several components share bytes
bool IsHalfFormat(GraphicsFormat format);
bool IsFloatFormat(GraphicsFormat format);   ///< of 32 bits per component
bool IsIEEE754Format(GraphicsFormat format); ///< half or float
bool IsIntegerFormat(GraphicsFormat format);
bool IsUIntFormat(GraphicsFormat format);
bool IsSIntFormat(GraphicsFormat format);
bool IsNormFormat(GraphicsFormat format);
bool IsUNormFormat(GraphicsFormat format);
bool IsSNormFormat(GraphicsFormat format);
bool IsSignedFormat(GraphicsFormat format); ///< components may be negative

} // namespace GraphicsFormatUtility

} // namespace limn
