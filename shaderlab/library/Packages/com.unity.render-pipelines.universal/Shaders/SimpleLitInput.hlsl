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
    outSurfaceData = (SurfaceData)0;
    outSurfaceData.alpha = albedoAlpha.a * _BaseColor.a;
    AlphaDiscard(outSurfaceData.alpha, _Cutoff);
    outSurfaceData.albedo = AlphaModulate(albedoAlpha.rgb * _BaseColor.rgb, outSurfaceData.alpha);
    float4 specular = SampleSpecularSmoothness(uv, outSurfaceData.alpha, _SpecColor,
                                               TEXTURE2D_ARGS(_SpecGlossMap, sampler_SpecGlossMap));
    outSurfaceData.specular = specular.rgb;
    outSurfaceData.smoothness = specular.a;
    outSurfaceData.normalTS = SampleNormal(uv, TEXTURE2D_ARGS(_BumpMap, sampler_BumpMap));
    outSurfaceData.occlusion = 1.0;
    outSurfaceData.emission = SampleEmission(uv, _EmissionColor.rgb,
                                             TEXTURE2D_ARGS(_EmissionMap, sampler_EmissionMap));
}
#endif
