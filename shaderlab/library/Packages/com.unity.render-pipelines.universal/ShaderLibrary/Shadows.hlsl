// The shadow of the main light. All is lit unless a shadow map and its strength are set.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

#define MAX_SHADOW_CASCADES 4
#define BEYOND_SHADOW_FAR(shadowCoord) ((shadowCoord).z <= 0.0 || (shadowCoord).z >= 1.0)

#if !defined(_RECEIVE_SHADOWS_OFF)
#if defined(_MAIN_LIGHT_SHADOWS) || defined(_MAIN_LIGHT_SHADOWS_CASCADE) || \
    defined(_MAIN_LIGHT_SHADOWS_SCREEN)
#define MAIN_LIGHT_CALCULATE_SHADOWS
#if defined(_MAIN_LIGHT_SHADOWS) && !defined(_MAIN_LIGHT_SHADOWS_CASCADE)
#define REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR
#endif
#endif
#if defined(_ADDITIONAL_LIGHT_SHADOWS)
#define ADDITIONAL_LIGHT_CALCULATE_SHADOWS
#endif
#endif

// What is transparent is not in the picture of shadows that the screen has: it looks into the map.
#if defined(_MAIN_LIGHT_SHADOWS_SCREEN) && !defined(_SURFACE_TYPE_TRANSPARENT)
#define limn_ShadowsOfScreen
#endif

#define SHADOWMASK_NAME unity_ShadowMask
#define SHADOWMASK_SAMPLER_NAME samplerunity_ShadowMask
#define SAMPLE_SHADOWMASK(uv) float4(1, 1, 1, 1)

TEXTURE2D_SHADOW(_MainLightShadowmapTexture);
TEXTURE2D_X(_ScreenSpaceShadowmapTexture);
SAMPLER(sampler_ScreenSpaceShadowmapTexture);
#ifndef limn_LinearClampCompare
#define limn_LinearClampCompare
SAMPLER_CMP(sampler_LinearClampCompare);
#endif
// The name of older versions.
#define sampler_MainLightShadowmapTexture sampler_LinearClampCompare

cbuffer LightShadows
{
    float4x4 _MainLightWorldToShadow[MAX_SHADOW_CASCADES + 1];
    float4 _CascadeShadowSplitSpheres0; // xyz: centre
    float4 _CascadeShadowSplitSpheres1;
    float4 _CascadeShadowSplitSpheres2;
    float4 _CascadeShadowSplitSpheres3;
    float4 _CascadeShadowSplitSphereRadii; // squared
    float4 _MainLightShadowOffset0;        // of four samples: xy, zw
    float4 _MainLightShadowOffset1;
    float4 _MainLightShadowParams; // strength, soft or not, scale and bias of the fade by distance
    float4 _MainLightShadowmapSize;
    float4 _ShadowBias; // x: towards the light, y: along the normal; metres, negative
};

struct ShadowSamplingData
{
    float4 shadowOffset0;
    float4 shadowOffset1;
    float4 shadowmapSize;
    float softShadowQuality;
};

ShadowSamplingData GetMainLightShadowSamplingData()
{
    ShadowSamplingData data;
    data.shadowOffset0 = _MainLightShadowOffset0;
    data.shadowOffset1 = _MainLightShadowOffset1;
    data.shadowmapSize = _MainLightShadowmapSize;
    data.softShadowQuality = _MainLightShadowParams.y;
    return data;
}
float4 GetMainLightShadowParams() { return _MainLightShadowParams; }

// Four samples where shadows are soft; 1 is lit.
float SampleShadowmap(Texture2D shadowMap, SamplerComparisonState smp, float4 shadowCoord,
                      ShadowSamplingData samplingData, float4 shadowParams,
                      bool isPerspectiveProjection = true)
{
    if (isPerspectiveProjection)
    {
        shadowCoord.xyz /= shadowCoord.w;
    }
    float lit = shadowMap.SampleCmpLevelZero(smp, shadowCoord.xy, shadowCoord.z);
#ifdef _SHADOWS_SOFT
    if (shadowParams.y > 0.0)
    {
        float4 a = shadowCoord.xyxy + samplingData.shadowOffset0;
        float4 b = shadowCoord.xyxy + samplingData.shadowOffset1;
        lit = 0.25 * (shadowMap.SampleCmpLevelZero(smp, a.xy, shadowCoord.z) +
                      shadowMap.SampleCmpLevelZero(smp, a.zw, shadowCoord.z) +
                      shadowMap.SampleCmpLevelZero(smp, b.xy, shadowCoord.z) +
                      shadowMap.SampleCmpLevelZero(smp, b.zw, shadowCoord.z));
    }
#endif
    return BEYOND_SHADOW_FAR(shadowCoord) ? 1.0 : lerp(1.0, lit, shadowParams.x);
}

// Names of earlier versions of the library.
#define _MainLightShadowData _MainLightShadowParams
float GetMainLightShadowStrength() { return _MainLightShadowParams.x; }
float SampleShadowmap(float4 shadowCoord, Texture2D shadowMap, SamplerComparisonState smp,
                      ShadowSamplingData samplingData, float shadowStrength,
                      bool isPerspectiveProjection = true)
{
    return SampleShadowmap(shadowMap, smp, shadowCoord, samplingData,
                           float4(shadowStrength, 1.0, 0.0, 0.0), isPerspectiveProjection);
}

// The same of the main light's map, without a comparison sampler: where nobody set a map, what
// stands in for it is no depth texture.
float limn_MainLightLit(float2 uv, float depth)
{
    float2 size;
    _MainLightShadowmapTexture.GetDimensions(size.x, size.y);
    float2 texel = uv * size - 0.5;
    int2 low = (int2)clamp(floor(texel), 0.0, size - 1.0);
    int2 high = (int2)clamp(floor(texel) + 1.0, 0.0, size - 1.0);
    float4 stored = float4(_MainLightShadowmapTexture.Load(int3(low, 0)).r,
                           _MainLightShadowmapTexture.Load(int3(high.x, low.y, 0)).r,
                           _MainLightShadowmapTexture.Load(int3(low.x, high.y, 0)).r,
                           _MainLightShadowmapTexture.Load(int3(high, 0)).r);
#if defined(UNITY_REVERSED_Z)
    float4 lit = step(stored, depth);
#else
    float4 lit = step(depth, stored);
#endif
    float2 part = frac(texel);
    return lerp(lerp(lit.x, lit.y, part.x), lerp(lit.z, lit.w, part.x), part.y);
}
float limn_SampleMainLightShadowmap(float4 shadowCoord)
{
    float lit = limn_MainLightLit(shadowCoord.xy, shadowCoord.z);
#ifdef _SHADOWS_SOFT
    if (_MainLightShadowParams.y > 0.0)
    {
        float4 a = shadowCoord.xyxy + _MainLightShadowOffset0;
        float4 b = shadowCoord.xyxy + _MainLightShadowOffset1;
        float z = shadowCoord.z;
        lit = 0.25 * (limn_MainLightLit(a.xy, z) + limn_MainLightLit(a.zw, z) +
                      limn_MainLightLit(b.xy, z) + limn_MainLightLit(b.zw, z));
    }
#endif
    return BEYOND_SHADOW_FAR(shadowCoord) ? 1.0 : lerp(1.0, lit, _MainLightShadowParams.x);
}
float SampleScreenSpaceShadowmap(float4 shadowCoord)
{
    float2 uv = shadowCoord.xy / max(shadowCoord.w, 0.00001);
    return _ScreenSpaceShadowmapTexture.SampleLevel(sampler_ScreenSpaceShadowmapTexture, uv, 0).x;
}

// The first sphere that holds the position; the number of cascades where none does.
float ComputeCascadeIndex(float3 positionWS)
{
    float4 distances = float4(Length2(positionWS - _CascadeShadowSplitSpheres0.xyz),
                              Length2(positionWS - _CascadeShadowSplitSpheres1.xyz),
                              Length2(positionWS - _CascadeShadowSplitSpheres2.xyz),
                              Length2(positionWS - _CascadeShadowSplitSpheres3.xyz));
    bool4 inside = distances < _CascadeShadowSplitSphereRadii;
    return inside.x ? 0.0 : inside.y ? 1.0 : inside.z ? 2.0 : inside.w ? 3.0 : 4.0;
}
float4 TransformWorldToShadowCoord(float3 positionWS)
{
#ifdef limn_ShadowsOfScreen
    return ComputeScreenPos(TransformWorldToHClip(positionWS));
#elif defined(_MAIN_LIGHT_SHADOWS_CASCADE)
    uint cascade = (uint)ComputeCascadeIndex(positionWS);
#else
    uint cascade = 0;
#endif
#ifndef limn_ShadowsOfScreen
    return float4(mul(_MainLightWorldToShadow[cascade], float4(positionWS, 1.0)).xyz, 0.0);
#endif
}
float4 GetShadowCoord(VertexPositionInputs vertexInput)
{
#ifdef limn_ShadowsOfScreen
    return ComputeScreenPos(vertexInput.positionCS);
#else
    return TransformWorldToShadowCoord(vertexInput.positionWS);
#endif
}

float MainLightRealtimeShadow(float4 shadowCoord)
{
#if !defined(MAIN_LIGHT_CALCULATE_SHADOWS)
    return 1.0;
#elif defined(limn_ShadowsOfScreen)
    return SampleScreenSpaceShadowmap(shadowCoord);
#else
    return limn_SampleMainLightShadowmap(shadowCoord);
#endif
}
#ifdef ADDITIONAL_LIGHT_CALCULATE_SHADOWS
[limn_Lacks("shadows of additional lights", "they light everything")]
#endif
float AdditionalLightRealtimeShadow(int lightIndex, float3 positionWS, float3 lightDirection)
{
    return 1.0;
}
float AdditionalLightRealtimeShadow(int lightIndex, float3 positionWS)
{
    return AdditionalLightRealtimeShadow(lightIndex, positionWS, float3(1, 0, 0));
}

// 0 near the camera, 1 where shadows end.
float GetMainLightShadowFade(float3 positionWS)
{
    float distanceSqr = Length2(positionWS - _WorldSpaceCameraPos);
    return saturate(distanceSqr * _MainLightShadowParams.z + _MainLightShadowParams.w);
}
float ApplyShadowFade(float shadowAttenuation, float3 positionWS)
{
    return lerp(shadowAttenuation, 1.0, GetMainLightShadowFade(positionWS));
}
float GetAdditionalLightShadowFade(float3 positionWS) { return 0.0; }

float MixRealtimeAndBakedShadows(float realtimeShadow, float bakedShadow, float shadowFade)
{
    return lerp(realtimeShadow, bakedShadow, shadowFade);
}
float BakedShadow(float4 shadowMask, float4 occlusionProbeChannels)
{
    return 1.0 + dot(shadowMask - 1.0, occlusionProbeChannels);
}
float MainLightShadow(float4 shadowCoord, float3 positionWS, float4 shadowMask,
                      float4 occlusionProbeChannels)
{
    float realtime = MainLightRealtimeShadow(shadowCoord);
#ifdef MAIN_LIGHT_CALCULATE_SHADOWS
    return MixRealtimeAndBakedShadows(realtime, 1.0, GetMainLightShadowFade(positionWS));
#else
    return realtime;
#endif
}
float AdditionalLightShadow(int lightIndex, float3 positionWS, float3 lightDirection,
                            float4 shadowMask, float4 occlusionProbeChannels)
{
    return AdditionalLightRealtimeShadow(lightIndex, positionWS, lightDirection);
}

// Moves what casts a shadow away from the light, so that it does not shadow itself.
float3 ApplyShadowBias(float3 positionWS, float3 normalWS, float3 lightDirection)
{
    float grazing = 1.0 - saturate(dot(lightDirection, normalWS));
    return positionWS + lightDirection * _ShadowBias.x + normalWS * (grazing * _ShadowBias.y);
}
// Keeps what lies in front of the near plane on it.
float4 ApplyShadowClamping(float4 positionCS)
{
#if defined(UNITY_REVERSED_Z)
    positionCS.z = min(positionCS.z, positionCS.w * UNITY_NEAR_CLIP_VALUE);
#else
    positionCS.z = max(positionCS.z, positionCS.w * UNITY_NEAR_CLIP_VALUE);
#endif
    return positionCS;
}
