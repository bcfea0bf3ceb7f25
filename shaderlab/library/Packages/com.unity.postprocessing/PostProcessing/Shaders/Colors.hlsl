// Colour spaces of the Post-processing Stack v2.
#pragma once

#include "Packages/com.unity.postprocessing/PostProcessing/Shaders/StdLib.hlsl"

float SRGBToLinear(float c)
{
    return c <= 0.04045 ? c / 12.92 : PositivePow((c + 0.055) / 1.055, 2.4);
}
float3 SRGBToLinear(float3 c)
{
    return float3(SRGBToLinear(c.r), SRGBToLinear(c.g), SRGBToLinear(c.b));
}
float4 SRGBToLinear(float4 c) { return float4(SRGBToLinear(c.rgb), c.a); }
float LinearToSRGB(float c)
{
    return c <= 0.0031308 ? c * 12.92 : 1.055 * PositivePow(c, 1.0 / 2.4) - 0.055;
}
float3 LinearToSRGB(float3 c)
{
    return float3(LinearToSRGB(c.r), LinearToSRGB(c.g), LinearToSRGB(c.b));
}
float4 LinearToSRGB(float4 c) { return float4(LinearToSRGB(c.rgb), c.a); }

float3 HsvToRgb(float3 c)
{
    float3 away = abs(frac(c.xxx + float3(1.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0);
    return c.z * lerp(float3(1, 1, 1), saturate(away - 1.0), c.y);
}
float3 RgbToHsv(float3 c)
{
    float high = Max3(c.r, c.g, c.b);
    float range = high - Min3(c.r, c.g, c.b);
    float safeRange = max(range, 1e-10);
    float hue = high == c.r   ? (c.g - c.b) / safeRange
                : high == c.g ? (c.b - c.r) / safeRange + 2.0
                              : (c.r - c.g) / safeRange + 4.0;
    return float3(frac(hue / 6.0), range / max(high, 1e-10), high);
}
