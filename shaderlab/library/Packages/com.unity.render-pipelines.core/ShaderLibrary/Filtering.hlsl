// Smoother reading of textures than one bilinear sample gives.
#pragma once
#ifndef UNITY_FILTERING_INCLUDED
#define UNITY_FILTERING_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

// Weights of the neighbours of a position between texels (0...1) by a cubic and a quadratic
// B-spline.
float2 BSpline3Leftmost(float2 x) { return 0.16666667 - x * 0.5 + x * x * (0.5 - x * 0.16666667); }
float2 BSpline3MiddleLeft(float2 x) { return 0.66666667 + x * x * (x * 0.5 - 1.0); }
float2 BSpline3MiddleRight(float2 x) { return BSpline3MiddleLeft(1.0 - x); }
float2 BSpline3Rightmost(float2 x) { return x * x * x * 0.16666667; }
float2 BSpline2Left(float2 x) { return 0.5 * Sq(1.0 - x); }
float2 BSpline2Middle(float2 x) { return 0.5 + x - x * x; }
float2 BSpline2Right(float2 x) { return 0.5 * x * x; }

// Sigg and Hadwiger 2005: two bilinear samples a row stand for its four neighbours.
// texSize: width, height, 1/width, 1/height
float4 SampleTexture2DBicubic(Texture2D tex, SamplerState smp, float2 coord, float4 texSize,
                              float2 maxCoord, uint unused)
{
    float2 texel = coord * texSize.xy - 0.5;
    float2 base = floor(texel);
    float2 f = texel - base;
    float2 low = BSpline3Leftmost(f) + BSpline3MiddleLeft(f);
    float2 high = BSpline3MiddleRight(f) + BSpline3Rightmost(f);
    float2 p0 = (base - 0.5 + BSpline3MiddleLeft(f) / low) * texSize.zw;
    float2 p1 = (base + 1.5 + BSpline3Rightmost(f) / high) * texSize.zw;
    p0 = min(p0, maxCoord);
    p1 = min(p1, maxCoord);
    float4 bottom = low.x * tex.SampleLevel(smp, p0, 0) +
                    high.x * tex.SampleLevel(smp, float2(p1.x, p0.y), 0);
    float4 top = low.x * tex.SampleLevel(smp, float2(p0.x, p1.y), 0) +
                 high.x * tex.SampleLevel(smp, p1, 0);
    return low.y * bottom + high.y * top;
}
#endif
