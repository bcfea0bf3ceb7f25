// What post-processing shaders share.
#pragma once

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Random.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/Shaders/Utils/Fullscreen.hlsl"

float GetLuminance(float3 colorLinear)
{
#ifdef _TONEMAP_ACES
    return AcesLuminance(colorLinear);
#else
    return Luminance(colorLinear);
#endif
}

float3 GetSRGBToLinear(float3 c) { return SRGBToLinear(c); }
float4 GetSRGBToLinear(float4 c) { return SRGBToLinear(c); }
float3 GetLinearToSRGB(float3 c) { return LinearToSRGB(c); }
float4 GetLinearToSRGB(float4 c) { return LinearToSRGB(c); }

// Tints what is away from the centre.
float3 ApplyVignette(float3 input, float2 uv, float2 center, float intensity, float roundness,
                     float smoothness, float3 color)
{
    float2 away = abs(uv - center) * intensity * float2(roundness, 1.0);
    return input * lerp(color, float3(1, 1, 1), pow(saturate(1.0 - dot(away, away)), smoothness));
}

float3 ApplyTonemap(float3 input)
{
#if defined(_TONEMAP_ACES)
    input = AcesTonemap(unity_to_ACES(input));
#elif defined(_TONEMAP_NEUTRAL)
    input = NeutralTonemap(input);
#endif
    return saturate(input);
}
