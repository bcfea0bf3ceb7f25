#pragma once

#include <limn/core/Flags.h>

namespace limn
{

/// The point in a frame at which a pass runs. Any number in between is allowed: `event + 1`.
/// Unity: UnityEngine.Rendering.Universal.RenderPassEvent (URP 14).
enum class RenderPassEvent
{
    BeforeRendering = 0,
    BeforeRenderingShadows = 50,
    AfterRenderingShadows = 100,
    BeforeRenderingPrePasses = 150,
    AfterRenderingPrePasses = 200,
    BeforeRenderingGbuffer = 210,
    AfterRenderingGbuffer = 220,
    BeforeRenderingDeferredLights = 230,
    AfterRenderingDeferredLights = 240,
    BeforeRenderingOpaques = 250,
    AfterRenderingOpaques = 300,
    BeforeRenderingSkybox = 350,
    AfterRenderingSkybox = 400,
    BeforeRenderingTransparents = 450,
    AfterRenderingTransparents = 500,
    BeforeRenderingPostProcessing = 550,
    AfterRenderingPostProcessing = 600,
    AfterRendering = 1000
};
constexpr RenderPassEvent operator+(RenderPassEvent event, int offset)
{
    return static_cast<RenderPassEvent>(static_cast<int>(event) + offset);
}
constexpr RenderPassEvent operator-(RenderPassEvent event, int offset)
{
    return event + -offset;
}

/// The four parts of a frame. Unity: ScriptableRenderer.RenderPassBlock.
enum class RenderPassBlock
{
    BeforeRendering = 0,          ///< events below 150: camera matrices are not set
    MainRenderingOpaque = 1,      ///< 150...299
    MainRenderingTransparent = 2, ///< 300...599
    AfterRendering = 3            ///< 600 and later
};
constexpr RenderPassBlock BlockOf(RenderPassEvent event)
{
    const int e = static_cast<int>(event);
    return e < 150   ? RenderPassBlock::BeforeRendering
           : e < 300 ? RenderPassBlock::MainRenderingOpaque
           : e < 600 ? RenderPassBlock::MainRenderingTransparent
                     : RenderPassBlock::AfterRendering;
}

/// The textures that a pass needs the renderer to make before it runs; bit flags.
/// Unity: UnityEngine.Rendering.Universal.ScriptableRenderPassInput (URP 14).
enum class ScriptableRenderPassInput
{
    None = 0,
    Depth = 1,
    Normal = 2,
    Color = 4,
    Motion = 8
};
template <>
inline constexpr bool k_IsFlags<ScriptableRenderPassInput> = true;

} // namespace limn
