#pragma once
#ifndef UNITY_UI_INCLUDED
#define UNITY_UI_INCLUDED
#include "UnityCG.cginc"

// 1 inside clipRect (x and y of the lower corner, then of the upper one), 0 outside.
float UnityGet2DClipping(float2 position, float4 clipRect)
{
    float2 inside = step(clipRect.xy, position) * step(position, clipRect.zw);
    return inside.x * inside.y;
}

fixed4 UnityGetUIDiffuseColor(float2 position, sampler2D mainTexture, sampler2D alphaTexture,
                              fixed4 textureSampleAdd)
{
    fixed opacity = tex2D(alphaTexture, position).r;
    return textureSampleAdd + fixed4(tex2D(mainTexture, position).rgb, opacity);
}

// Vertex colours of the UI are sRGB: a line for the values up to 18 of 255, a cubic above.
half limn_UIGammaToLinear(half value)
{
    half low = 0.0849710 * value - 0.000163029;
    half high = value * (value * (value * 0.265885 + 0.736584) - 0.00980184) + 0.00319697;
    return value < 0.0725490 ? low : high;
}
half3 UIGammaToLinear(half3 value)
{
    return half3(limn_UIGammaToLinear(value.r), limn_UIGammaToLinear(value.g),
                 limn_UIGammaToLinear(value.b));
}
#endif
