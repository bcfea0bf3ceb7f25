// The textures that most lit shaders have, and how they are read.
#pragma once
#ifndef UNIVERSAL_INPUT_SURFACE_INCLUDED
#define UNIVERSAL_INPUT_SURFACE_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceData.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Packing.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"

TEXTURE2D(_BaseMap);
SAMPLER(sampler_BaseMap);
float4 _BaseMap_TexelSize;
TEXTURE2D(_BumpMap);
SAMPLER(sampler_BumpMap);
TEXTURE2D(_EmissionMap);
SAMPLER(sampler_EmissionMap);

// Opacity; discards the fragment where _ALPHATEST_ON asks for it.
float Alpha(float albedoAlpha, float4 color, float cutoff)
{
#if defined(_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A) || defined(_GLOSSINESS_FROM_BASE_ALPHA)
    float alpha = color.a;
#else
    float alpha = albedoAlpha * color.a;
#endif
    AlphaDiscard(alpha, cutoff);
    return alpha;
}
float4 SampleAlbedoAlpha(float2 uv, TEXTURE2D_PARAM(albedoAlphaMap, sampler_albedoAlphaMap))
{
    return SAMPLE_TEXTURE2D(albedoAlphaMap, sampler_albedoAlphaMap, uv);
}
float3 SampleNormal(float2 uv, TEXTURE2D_PARAM(bumpMap, sampler_bumpMap), float scale = 1.0)
{
#ifdef _NORMALMAP
    return UnpackNormalScale(SAMPLE_TEXTURE2D(bumpMap, sampler_bumpMap, uv), scale);
#else
    return float3(0, 0, 1);
#endif
}
float3 SampleEmission(float2 uv, float3 emissionColor,
                      TEXTURE2D_PARAM(emissionMap, sampler_emissionMap))
{
#ifdef _EMISSION
    return SAMPLE_TEXTURE2D(emissionMap, sampler_emissionMap, uv).rgb * emissionColor;
#else
    return float3(0, 0, 0);
#endif
}
#endif
