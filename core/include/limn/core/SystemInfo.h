#pragma once

#include <limn/core/Flags.h>
#include <limn/core/GraphicsFormat.h>

namespace limn
{

/// The uses of a format, with Unity's values. Unity: UnityEngine.Experimental.Rendering.FormatUsage
/// (2022.3).
enum class FormatUsage
{
    Sample = 0,
    Linear = 1, ///< sampled with a filter
    Sparse = 2, ///< never
    Render = 4,
    Blend = 5,
    GetPixels = 6, ///< this and the next two: the texels that textures are made from are available
    SetPixels = 7,
    SetPixels32 = 8,
    ReadPixels = 9,
    LoadStore = 10, ///< kernels write to it
    MSAA2x = 11,
    MSAA4x = 12,
    MSAA8x = 13,
    StencilSampling = 16 ///< never
};

/// The uses of a format as flags, which Unity 6 has, with Unity's values.
/// Unity: UnityEngine.Experimental.Rendering.GraphicsFormatUsage (6).
enum class GraphicsFormatUsage
{
    None = 0,
    Sample = 1 << 0,
    Linear = 1 << 1,
    Sparse = 1 << 2,
    Render = 1 << 4,
    Blend = 1 << 5,
    GetPixels = 1 << 6,
    SetPixels = 1 << 7,
    SetPixels32 = 1 << 8,
    ReadPixels = 1 << 9,
    LoadStore = 1 << 10,
    MSAA2x = 1 << 11,
    MSAA4x = 1 << 12,
    MSAA8x = 1 << 13,
    StencilSampling = 1 << 16
};
template <>
inline constexpr bool k_IsFlags<GraphicsFormatUsage> = true;

/// The purposes for which a platform has a default format.
/// Unity: UnityEngine.Experimental.Rendering.DefaultFormat (2022.3).
enum class DefaultFormat
{
    LDR = 0,
    HDR = 1,
    DepthStencil = 2,
    Shadow = 3,
    Video = 4 ///< throws ContractError: there is none
};

/// Unity: UnityEngine.SystemInfo (2022.3).
namespace SystemInfo
{

/// Returns whether the device that was made last and still exists supports the usage. If there is
/// none, it returns what every Vulkan device supports. Any thread may call it, while no device is
/// made or destroyed.
bool IsFormatSupported(GraphicsFormat format, FormatUsage usage);
/// Returns whether the device supports all of the usages; false for None.
bool IsFormatSupported(GraphicsFormat format, GraphicsFormatUsage usage);
/// Returns the format, or one with at least as many bits per component that supports the usage,
/// or None if there is no such format. Unity's own choice is the platform's.
GraphicsFormat GetCompatibleFormat(GraphicsFormat format, FormatUsage usage);
GraphicsFormat GetCompatibleFormat(GraphicsFormat format, GraphicsFormatUsage usage);
/// LDR is R8G8B8A8_SRGB, or R8G8B8A8_UNorm in gamma space. @throws ContractError for Video
GraphicsFormat GetGraphicsFormat(DefaultFormat format);
/// Returns whether the format can be a target: a depth format as a depth.
inline bool SupportsRenderTextureFormat(RenderTextureFormat format)
{
    return IsFormatSupported(ToGraphicsFormat(format), FormatUsage::Render);
}
inline bool SupportsBlendingOnRenderTextureFormat(RenderTextureFormat format)
{
    return IsFormatSupported(ToGraphicsFormat(format), FormatUsage::Blend);
}
inline bool SupportsRandomWriteOnRenderTextureFormat(RenderTextureFormat format)
{
    return IsFormatSupported(ToGraphicsFormat(format), FormatUsage::LoadStore);
}
/// Returns whether the format can be sampled.
inline bool SupportsTextureFormat(TextureFormat format)
{
    return IsFormatSupported(ToGraphicsFormat(format, false), FormatUsage::Sample);
}

} // namespace SystemInfo

/// Returns whether every Vulkan device supports it, by the tables of the specification.
bool EveryDeviceSupports(GraphicsFormat format, FormatUsage usage);

} // namespace limn
