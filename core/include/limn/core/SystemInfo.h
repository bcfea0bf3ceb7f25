#pragma once

#include <limn/core/GraphicsFormat.h>

namespace limn
{

/// What a format is wanted for; values Unity's.
/// Unity: UnityEngine.Experimental.Rendering.FormatUsage (2022.3).
enum class FormatUsage
{
    Sample = 0,
    Linear = 1, ///< sampled with a filter
    Sparse = 2, ///< never
    Render = 4,
    Blend = 5,
    GetPixels = 6, ///< this and the next two: what textures are made from is at hand
    SetPixels = 7,
    SetPixels32 = 8,
    ReadPixels = 9,
    LoadStore = 10, ///< kernels write to it
    MSAA2x = 11,
    MSAA4x = 12,
    MSAA8x = 13,
    StencilSampling = 16 ///< never
};

/// Unity: UnityEngine.SystemInfo (2022.3).
namespace SystemInfo
{

/// Of the device that was made last and still is. Where there is none, what every Vulkan device
/// does. Any thread, while none is made or goes.
bool IsFormatSupported(GraphicsFormat format, FormatUsage usage);
/// As a target: a depth format as a depth.
bool SupportsRenderTextureFormat(RenderTextureFormat format);

} // namespace SystemInfo

/// Whether each Vulkan device does it, by the tables of the specification.
bool EveryDeviceSupports(GraphicsFormat format, FormatUsage usage);

} // namespace limn
