// Properties of Universal Render Pipeline/Simple Lit, and the surface they make.
#pragma once
#ifndef UNIVERSAL_SIMPLE_LIT_INPUT_INCLUDED
#define UNIVERSAL_SIMPLE_LIT_INPUT_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceInput.hlsl"

CBUFFER_START(UnityPerMaterial)
float4 _BaseMap_ST;
float4 _BaseColor;
float4 _SpecColor;
float4 _EmissionColor;
float _Cutoff;
float _Surface;
CBUFFER_END

TEXTURE2D(_SpecGlossMap);
SAMPLER(sampler_SpecGlossMap);

float4 SampleSpecularSmoothness(float2 uv, float alpha, float4 specColor,
                                TEXTURE2D_PARAM(specMap, sampler_specMap))
{
#if defined(_SPECGLOSSMAP)
    float4 specularSmoothness = SAMPLE_TEXTURE2D(specMap, sampler_specMap, uv) * specColor;
#elif defined(_SPECULAR_COLOR)
    float4 specularSmoothness = specColor;
#else
    float4 specularSmoothness = float4(0, 0, 0, 1);
#endif
#ifdef _GLOSSINESS_FROM_BASE_ALPHA
    specularSmoothness.a = alpha;
#endif
    return specularSmoothness;
}

void InitializeSimpleLitSurfaceData(float2 uv, out SurfaceData outSurfaceData)
{
    float4 albedoAlpha = SampleAlbedoAlpha(uv, TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap));
    float alpha = _BaseColor.a * albedoAlpha.a;
    AlphaDiscard(alpha, _Cutoff);
    float4 shine = SampleSpecularSmoothness(uv, alpha, _SpecColor,
                                            TEXTURE2D_ARGS(_SpecGlossMap, sampler_SpecGlossMap));
    float3 glow = _EmissionColor.rgb;
    glow = SampleEmission(uv, glow, TEXTURE2D_ARGS(_EmissionMap, sampler_EmissionMap));

    outSurfaceData = (SurfaceData)0;
    outSurfaceData.normalTS = SampleNormal(uv, TEXTURE2D_ARGS(_BumpMap, sampler_BumpMap));
    outSurfaceData.albedo = AlphaModulate(_BaseColor.rgb * albedoAlpha.rgb, alpha);
    outSurfaceData.alpha = alpha;
    outSurfaceData.emission = glow;
    outSurfaceData.occlusion = 1.0;
    outSurfaceData.smoothness = shine.a;
    outSurfaceData.specular = shine.rgb;
}
#endif
