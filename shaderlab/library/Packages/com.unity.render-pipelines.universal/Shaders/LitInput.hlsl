// Properties of Universal Render Pipeline/Lit, and the surface they make.
#pragma once
#ifndef UNIVERSAL_LIT_INPUT_INCLUDED
#define UNIVERSAL_LIT_INPUT_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceInput.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/ParallaxMapping.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DBuffer.hlsl"

#if defined(_DETAIL_MULX2) || defined(_DETAIL_SCALED)
#define _DETAIL
#endif

CBUFFER_START(UnityPerMaterial)
float4 _BaseMap_ST;
float4 _DetailAlbedoMap_ST;
float4 _BaseColor;
float4 _SpecColor;
float4 _EmissionColor;
float _Cutoff;
float _Smoothness;
float _Metallic;
float _BumpScale;
float _Parallax;
float _OcclusionStrength;
float _ClearCoatMask;
float _ClearCoatSmoothness;
float _DetailAlbedoMapScale;
float _DetailNormalMapScale;
float _Surface;
CBUFFER_END

TEXTURE2D(_ParallaxMap);
SAMPLER(sampler_ParallaxMap);
TEXTURE2D(_OcclusionMap);
SAMPLER(sampler_OcclusionMap);
TEXTURE2D(_DetailMask);
SAMPLER(sampler_DetailMask);
TEXTURE2D(_DetailAlbedoMap);
SAMPLER(sampler_DetailAlbedoMap);
TEXTURE2D(_DetailNormalMap);
SAMPLER(sampler_DetailNormalMap);
TEXTURE2D(_MetallicGlossMap);
SAMPLER(sampler_MetallicGlossMap);
TEXTURE2D(_SpecGlossMap);
SAMPLER(sampler_SpecGlossMap);
TEXTURE2D(_ClearCoatMap);
SAMPLER(sampler_ClearCoatMap);

#ifdef _SPECULAR_SETUP
#define SAMPLE_METALLICSPECULAR(uv) SAMPLE_TEXTURE2D(_SpecGlossMap, sampler_SpecGlossMap, uv)
#else
#define SAMPLE_METALLICSPECULAR(uv) \
    SAMPLE_TEXTURE2D(_MetallicGlossMap, sampler_MetallicGlossMap, uv)
#endif

// rgb: specular colour, or r: metallic; a: smoothness
float4 SampleMetallicSpecGloss(float2 uv, float albedoAlpha)
{
#ifdef _METALLICSPECGLOSSMAP
    float4 specGloss = SAMPLE_METALLICSPECULAR(uv);
    float smoothness = specGloss.a;
#else
#ifdef _SPECULAR_SETUP
    float4 specGloss = float4(_SpecColor.rgb, 1.0);
#else
    float4 specGloss = _Metallic.rrrr;
#endif
    float smoothness = 1.0;
#endif
#ifdef _SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A
    smoothness = albedoAlpha;
#endif
    return float4(specGloss.rgb, smoothness * _Smoothness);
}

float SampleOcclusion(float2 uv)
{
#ifdef _OCCLUSIONMAP
    float occlusion = SAMPLE_TEXTURE2D(_OcclusionMap, sampler_OcclusionMap, uv).g;
    return LerpWhiteTo(occlusion, _OcclusionStrength);
#else
    return 1.0;
#endif
}

// Mask and smoothness of the coat
float2 SampleClearCoat(float2 uv)
{
#if defined(_CLEARCOAT) || defined(_CLEARCOATMAP)
    float2 coat = float2(_ClearCoatMask, _ClearCoatSmoothness);
#ifdef _CLEARCOATMAP
    coat *= SAMPLE_TEXTURE2D(_ClearCoatMap, sampler_ClearCoatMap, uv).rg;
#endif
    return coat;
#else
    return float2(0, 1);
#endif
}

void ApplyPerPixelDisplacement(float3 viewDirTS, inout float2 uv)
{
#ifdef _PARALLAXMAP
    uv += ParallaxMapping(TEXTURE2D_ARGS(_ParallaxMap, sampler_ParallaxMap), viewDirTS, _Parallax,
                          uv);
#endif
}

// A detail of mid grey leaves the colour as it is.
float3 ScaleDetailAlbedo(float3 detailAlbedo, float scale)
{
    return 2.0 * detailAlbedo * scale - scale + 1.0;
}
float3 ApplyDetailAlbedo(float2 detailUv, float3 albedo, float detailMask)
{
#ifdef _DETAIL
    float3 detail =
        SAMPLE_TEXTURE2D(_DetailAlbedoMap, sampler_DetailAlbedoMap, detailUv).rgb;
#ifdef _DETAIL_SCALED
    detail = ScaleDetailAlbedo(detail, _DetailAlbedoMapScale);
#else
    detail *= 2.0;
#endif
    return albedo * LerpWhiteTo(detail, detailMask);
#else
    return albedo;
#endif
}
float3 ApplyDetailNormal(float2 detailUv, float3 normalTS, float detailMask)
{
#ifdef _DETAIL
    float4 packed = SAMPLE_TEXTURE2D(_DetailNormalMap, sampler_DetailNormalMap, detailUv);
    float3 detail = UnpackNormalScale(packed, _DetailNormalMapScale);
    return lerp(normalTS, BlendNormalRNM(normalTS, normalize(detail)), detailMask);
#else
    return normalTS;
#endif
}

void InitializeStandardLitSurfaceData(float2 uv, out SurfaceData outSurfaceData)
{
    float4 albedoAlpha = SampleAlbedoAlpha(uv, TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap));
    float4 specGloss = SampleMetallicSpecGloss(uv, albedoAlpha.a);
    float2 coat = SampleClearCoat(uv);

    outSurfaceData = (SurfaceData)0;
    outSurfaceData.alpha = Alpha(albedoAlpha.a, _BaseColor, _Cutoff);
    float3 albedo = AlphaModulate(_BaseColor.rgb * albedoAlpha.rgb, outSurfaceData.alpha);
    float3 normal = SampleNormal(uv, TEXTURE2D_ARGS(_BumpMap, sampler_BumpMap), _BumpScale);
#ifdef _DETAIL
    float2 detailUv = TRANSFORM_TEX(uv, _DetailAlbedoMap);
    float where = SAMPLE_TEXTURE2D(_DetailMask, sampler_DetailMask, uv).a;
    normal = ApplyDetailNormal(detailUv, normal, where);
    albedo = ApplyDetailAlbedo(detailUv, albedo, where);
#endif
    outSurfaceData.normalTS = normal;
    outSurfaceData.albedo = albedo;
#ifdef _SPECULAR_SETUP
    outSurfaceData.specular = specGloss.rgb;
    outSurfaceData.metallic = 1.0;
#else
    outSurfaceData.metallic = specGloss.r;
#endif
    outSurfaceData.clearCoatMask = coat.r;
    outSurfaceData.clearCoatSmoothness = coat.g;
    outSurfaceData.occlusion = SampleOcclusion(uv);
    outSurfaceData.smoothness = specGloss.a;
    float3 emission = _EmissionColor.rgb;
    outSurfaceData.emission =
        SampleEmission(uv, emission, TEXTURE2D_ARGS(_EmissionMap, sampler_EmissionMap));
}
#endif
