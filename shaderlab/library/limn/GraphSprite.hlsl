// What the generated passes of sprites have in common.
#pragma once
#include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/Core2D.hlsl"

PackedVaryings vert(Attributes input)
{
    input.positionOS = UnityFlipSprite(input.positionOS, unity_SpriteProps.xy);
    Varyings output = BuildVaryings(input);
#ifdef VARYINGS_NEED_COLOR
    output.color *= unity_SpriteColor;
#endif
#if SHADERPASS == SHADERPASS_SPRITENORMAL
    output.normalWS = -GetViewForwardDir();
#endif
    return PackVaryings(output);
}

// The graph's colour, times the vertex's.
half4 limn_GraphSpriteColor(Varyings unpacked, SurfaceDescription surface)
{
#ifdef UNIVERSAL_USELEGACYSPRITEBLOCKS
    half4 color = surface.SpriteColor;
#elif SHADERPASS == SHADERPASS_SPRITENORMAL
    half4 color = half4(1, 1, 1, surface.Alpha);
#else
    half4 color = half4(surface.BaseColor, surface.Alpha);
#endif
#if ALPHA_CLIP_THRESHOLD
    clip(color.a - surface.AlphaClipThreshold);
#endif
#if defined(VARYINGS_NEED_COLOR) && !defined(_DISABLE_COLOR_TINT) && \
    SHADERPASS != SHADERPASS_SPRITENORMAL
    color *= unpacked.color;
#endif
    return color;
}
