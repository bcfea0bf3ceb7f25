#pragma once

#include <cstdint>
#include <limn/core/GraphicsFormat.h>
#include <string_view>

namespace limn
{

/// Questions about formats. If Unity's answer depends on the platform, the answer here is about
/// what limn makes. Unity: UnityEngine.Experimental.Rendering.GraphicsFormatUtility (2022.3).
class GraphicsFormatUtility
{
public:
    static GraphicsFormat GetGraphicsFormat(RenderTextureFormat format, bool isSRGB)
    {
        return ToGraphicsFormat(format, isSRGB);
    }
    static GraphicsFormat GetGraphicsFormat(RenderTextureFormat format,
                                            RenderTextureReadWrite readWrite)
    {
        return ToGraphicsFormat(format, readWrite != RenderTextureReadWrite::Linear);
    }
    /// Returns the format that a texture's format stands for; None for TextureFormat::ARGB32 and
    /// ARGB4444.
    static GraphicsFormat GetGraphicsFormat(TextureFormat format, bool isSRGB)
    {
        return ToGraphicsFormat(format, isSRGB);
    }
    /// Returns the older name that stands for the format or its sRGB-encoded pair; Default if there
    /// is none.
    static RenderTextureFormat GetRenderTextureFormat(GraphicsFormat format);
    /// Returns a format with at least this many bits of both: D32_SFloat, or D32_SFloat_S8_UInt if
    /// there are bits of stencil; None for no bits.
    /// @throws ContractError for negative numbers, more than 32 bits of depth or 8 of stencil
    static GraphicsFormat GetDepthStencilFormat(int minimumDepthBits, int minimumStencilBits);
    /// Returns a depth-stencil format, with a stencil for more than 16 bits, as
    /// RenderTextureDescriptor::depthBufferBits does.
    static GraphicsFormat GetDepthStencilFormat(int minimumDepthBits)
    {
        return GetDepthStencilFormat(minimumDepthBits, minimumDepthBits > 16 ? 8 : 0);
    }
    static int GetDepthBits(GraphicsFormat f); ///< the bits in the format's name; 0 for others

    /// Returns the pair of a format with or without sRGB-encoded texels, or the format itself if it
    /// has none.
    static GraphicsFormat GetSRGBFormat(GraphicsFormat format);
    static GraphicsFormat GetLinearFormat(GraphicsFormat format);

    /// Returns Unity's spelling of a format.
    static std::string GetFormatString(GraphicsFormat format) { return ToString(format); }

    /// Returns the number of components of a texel of any format, also of a compressed one; depth
    /// and stencil count as none.
    static std::uint32_t GetComponentCount(GraphicsFormat format);
    static std::uint32_t GetColorComponentCount(GraphicsFormat format) ///< without alpha
    {
        return GetComponentCount(format) - GetAlphaComponentCount(format);
    }
    static std::uint32_t GetAlphaComponentCount(GraphicsFormat format); ///< 0 or 1
    static bool HasAlphaChannel(GraphicsFormat f) { return GetAlphaComponentCount(f) > 0; }

    // These return the texels per side and the bytes of a block; for a format that is not
    // compressed, a block is one texel.
    static std::uint32_t GetBlockWidth(GraphicsFormat format);
    static std::uint32_t GetBlockHeight(GraphicsFormat format);
    /// @throws ContractError for None and formats that leave the choice to Unity
    static std::uint32_t GetBlockSize(GraphicsFormat format);
    /// Returns the bytes of a picture of this format, in whole blocks.
    static std::uint32_t ComputeMipmapSize(int width, int height, GraphicsFormat format);

    static bool IsDepthFormat(GraphicsFormat format) ///< it has a depth
    {
        return limn::IsDepthFormat(format) && format != GraphicsFormat::S8_UInt;
    }
    static bool IsStencilFormat(GraphicsFormat f) { return HasStencil(f); } ///< it has a stencil
    static bool IsDepthStencilFormat(GraphicsFormat format) ///< it has a depth and a stencil
    {
        return limn::IsDepthFormat(format);
    }
    static bool IsSRGBFormat(GraphicsFormat format) { return limn::IsSRGBFormat(format); }
    static bool IsCompressedFormat(GraphicsFormat format);
    static bool IsPackedFormat(GraphicsFormat format) ///< several components share bytes
    {
        return Has(format, "Pack");
    }
    static bool IsHalfFormat(GraphicsFormat format) { return Has(format, "16_SFloat"); }
    static bool IsFloatFormat(GraphicsFormat format) ///< of 32 bits per component
    {
        return Has(format, "32_SFloat");
    }
    static bool IsIEEE754Format(GraphicsFormat format) ///< half or float
    {
        return IsHalfFormat(format) || IsFloatFormat(format);
    }
    static bool IsIntegerFormat(GraphicsFormat f) { return IsUIntFormat(f) || IsSIntFormat(f); }
    static bool IsUIntFormat(GraphicsFormat f) { return Has(f, "UInt") && !IsDepthFormat(f); }
    static bool IsSIntFormat(GraphicsFormat format) { return Has(format, "SInt"); }
    static bool IsNormFormat(GraphicsFormat f) { return IsUNormFormat(f) || IsSNormFormat(f); }
    static bool IsUNormFormat(GraphicsFormat f) { return Has(f, "UNorm") || IsSRGBFormat(f); }
    static bool IsSNormFormat(GraphicsFormat format) { return Has(format, "SNorm"); }
    static bool IsSignedFormat(GraphicsFormat format) ///< components may be negative
    {
        return Has(format, "SNorm") || Has(format, "SInt") || Has(format, "SFloat");
    }

private:
    /// Returns whether the format's name has a part.
    static bool Has(GraphicsFormat format, std::string_view part)
    {
        return std::string_view(ToString(format)).find(part) != std::string_view::npos;
    }
};

} // namespace limn
