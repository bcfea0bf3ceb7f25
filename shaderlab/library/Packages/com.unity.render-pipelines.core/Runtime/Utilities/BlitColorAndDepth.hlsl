// Blit.hlsl for colour and depth at once.
#pragma once
#ifndef UNITY_CORE_BLIT_COLOR_AND_DEPTH_INCLUDED
#define UNITY_CORE_BLIT_COLOR_AND_DEPTH_INCLUDED

#include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

TEXTURE2D_X_FLOAT(_InputDepthTexture);

float4 FragColorOnly(Varyings input) : SV_Target
{
    return SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_LinearClamp, input.texcoord, _BlitMipLevel);
}

struct PixelData
{
    float4 color : SV_Target;
    float depth : SV_Depth;
};

PixelData FragColorAndDepth(Varyings input)
{
    PixelData pixel;
    pixel.color = FragColorOnly(input);
    pixel.depth = SAMPLE_TEXTURE2D_X_LOD(_InputDepthTexture, sampler_PointClamp, input.texcoord,
                                         _BlitMipLevel)
                      .x;
    return pixel;
}
#endif
