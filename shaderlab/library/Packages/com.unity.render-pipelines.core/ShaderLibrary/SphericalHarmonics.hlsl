// Light by direction as spherical harmonics of orders 0 to 2 (Ramamoorthi and Hanrahan 2001).
#pragma once
#ifndef UNITY_SPHERICAL_HARMONICS_INCLUDED
#define UNITY_SPHERICAL_HARMONICS_INCLUDED

#include "limn/SphericalHarmonics.hlsl"
#ifdef UNITY_COLORSPACE_GAMMA
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"
#endif

// Light of harmonics, which are linear, in the colour space of the process.
float3 limn_InActiveSpace(float3 light)
{
#ifdef UNITY_COLORSPACE_GAMMA
    return LinearToSRGB(light);
#else
    return light;
#endif
}

float3 SHEvalLinearL0L1(float3 N, float4 shAr, float4 shAg, float4 shAb)
{
    return limn_ShLinear(float4(N, 1.0), shAr, shAg, shAb);
}
float3 SHEvalLinearL1(float3 N, float3 shAr, float3 shAg, float3 shAb)
{
    return float3(dot(shAr, N), dot(shAg, N), dot(shAb, N));
}
float3 SHEvalLinearL2(float3 N, float4 shBr, float4 shBg, float4 shBb, float4 shC)
{
    return limn_ShQuadratic(N, shBr, shBg, shBb, shC);
}
// Ar, Ag, Ab, Br, Bg, Bb, C
float3 SampleSH9(float4 SHCoefficients[7], float3 N)
{
    return limn_InActiveSpace(
        SHEvalLinearL0L1(N, SHCoefficients[0], SHCoefficients[1], SHCoefficients[2]) +
        SHEvalLinearL2(N, SHCoefficients[3], SHCoefficients[4], SHCoefficients[5],
                       SHCoefficients[6]));
}
#endif
