// Shadows of lights. All is lit unless a shadow map and its strength are set.
#pragma once
#ifndef UNIVERSAL_SHADOWS_INCLUDED
#define UNIVERSAL_SHADOWS_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonTexture.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Shadow/ShadowSamplingTent.hlsl"

#define MAX_SHADOW_CASCADES 4
#define MAX_PUNCTUAL_LIGHT_SHADOW_SLICES_IN_UBO 64
#define SOFT_SHADOW_QUALITY_OFF half(0.0)
#define SOFT_SHADOW_QUALITY_LOW half(1.0)
#define SOFT_SHADOW_QUALITY_MEDIUM half(2.0)
#define SOFT_SHADOW_QUALITY_HIGH half(3.0)
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
#ifndef REQUIRES_WORLD_SPACE_POS_INTERPOLATOR
#define REQUIRES_WORLD_SPACE_POS_INTERPOLATOR
#endif

// What is transparent is not in the picture of shadows that the screen has: it looks into the map.
#if defined(_MAIN_LIGHT_SHADOWS_SCREEN) && !defined(_SURFACE_TYPE_TRANSPARENT)
#define limn_ShadowsOfScreen
#endif

#define SHADOWMASK_NAME unity_ShadowMask
#define SHADOWMASK_SAMPLER_NAME samplerunity_ShadowMask
#define SAMPLE_SHADOWMASK(uv) float4(1, 1, 1, 1); // as in URP: its terrain writes none behind it

TEXTURE2D_SHADOW(_MainLightShadowmapTexture);
TEXTURE2D_SHADOW(_AdditionalLightsShadowmapTexture);
TEXTURE2D_X(_ScreenSpaceShadowmapTexture);
SAMPLER(sampler_ScreenSpaceShadowmapTexture);
#ifndef limn_LinearClampCompare
#define limn_LinearClampCompare
SAMPLER_CMP(sampler_LinearClampCompare);
#endif
// The name of older versions.
#define sampler_MainLightShadowmapTexture sampler_LinearClampCompare
#define sampler_AdditionalLightsShadowmapTexture sampler_LinearClampCompare
SAMPLER(limn_PointClamp);

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
    float4 _MainLightShadowParams; // strength, how soft (0...3), scale and bias of the distance's fade
    float4 _MainLightShadowmapSize;
    float4 _ShadowBias; // x: towards the light, y: along the normal; metres, negative
    // Far away from the world's origin, see RelativeSpaces.hlsl: where limn_Origin is in each shadow
    // map, and the spheres' centres relative to it.
    float4 limn_OriginToShadow[MAX_SHADOW_CASCADES + 1];
    float4 limn_CascadeCenters[MAX_SHADOW_CASCADES];
};

// Spots have one square of the map, points one for each side of a cube: +X, -X, +Y, -Y, +Z, -Z.
cbuffer AdditionalLightShadows
{
    float4x4 _AdditionalLightsWorldToShadow[MAX_PUNCTUAL_LIGHT_SHADOW_SLICES_IN_UBO];
    float4 limn_OriginToAdditionalShadow[MAX_PUNCTUAL_LIGHT_SHADOW_SLICES_IN_UBO];
    // By light: strength, how soft (0...3), 1 for a point, the first square; -1: no shadow
    float4 _AdditionalShadowParams[MAX_VISIBLE_LIGHTS];
    float4 _AdditionalShadowOffset0;
    float4 _AdditionalShadowOffset1;
    float4 _AdditionalShadowFadeParams; // scale and bias of the distance's fade
    float4 _AdditionalShadowmapSize;
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
ShadowSamplingData GetAdditionalLightShadowSamplingData(int index)
{
    ShadowSamplingData data;
    data.shadowOffset0 = _AdditionalShadowOffset0;
    data.shadowOffset1 = _AdditionalShadowOffset1;
    data.shadowmapSize = _AdditionalShadowmapSize;
    data.softShadowQuality = _AdditionalShadowParams[index].y;
    return data;
}
float4 GetAdditionalLightShadowParams(int lightIndex) { return _AdditionalShadowParams[lightIndex]; }
half GetAdditionalLightShadowStrenth(int lightIndex) { return _AdditionalShadowParams[lightIndex].x; }

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

// The same of a light's map, without a comparison sampler: where nobody set a map, what
// stands in for it is no depth texture.
float4 limn_LitTexels(float4 stored, float depth)
{
#if defined(UNITY_REVERSED_Z)
    return step(stored, depth);
#else
    return step(depth, stored);
#endif
}
// How much of a tent over [-width, width], of area 1, lies left of x.
float3 limn_TentLeftOf(float3 x, float width)
{
    float3 rest = 1.0 - saturate(abs(x) / width);
    return 0.5 + sign(x) * (0.5 - 0.5 * rest * rest);
}
// The texels around a place, weighted by the part of a tent that lies over each. What is fetched at a
// corner is texels (0, 1), (1, 1), (1, 0), (0, 0).
float limn_TentLit(Texture2D map, float2 uv, float depth, float width, int corners)
{
    float2 size;
    map.GetDimensions(size.x, size.y);
    float2 place = uv * size;
    float2 first = floor(place - width);
    float lit = 0.0;
    for (int y = 0; y < corners; ++y)
    {
        for (int x = 0; x < corners; ++x)
        {
            float2 corner = first + 2.0 * float2(x, y) + 1.0;
            float4 texels = limn_LitTexels(
                map.Gather(limn_PointClamp, corner / size), depth);
            float2 from = corner - place; // with 1 less and 1 more: the texels' borders
            float3 across = limn_TentLeftOf(from.x + float3(-1.0, 0.0, 1.0), width);
            float3 down = limn_TentLeftOf(from.y + float3(-1.0, 0.0, 1.0), width);
            float2 columns = across.yz - across.xy;
            float2 rows = down.yz - down.xy;
            lit += dot(texels, columns.xyyx * rows.yyxx);
        }
    }
    return lit;
}
// Bilinear.
float limn_BilinearLit(Texture2D map, float2 uv, float depth)
{
    float2 size;
    map.GetDimensions(size.x, size.y);
    float2 place = uv * size + 0.5;
    float2 corner = floor(place);
    float4 texels =
        limn_LitTexels(map.Gather(limn_PointClamp, corner / size), depth);
    float2 high = place - corner;
    float2 low = 1.0 - high;
    return dot(texels, float4(low.x, high.x, high.x, low.x) * float4(high.y, high.y, low.y, low.y));
}

float limn_FilteredLit(Texture2D map, float3 coord, float softness, float4 offset0, float4 offset1)
{
    float2 uv = coord.xy;
    float z = coord.z;
#ifdef _SHADOWS_SOFT
    if (softness > 2.5)
    {
        return limn_TentLit(map, uv, z, 3.5, 4);
    }
    if (softness > 1.5)
    {
        return limn_TentLit(map, uv, z, 2.5, 3);
    }
    if (softness > 0.5)
    {
        float4 a = uv.xyxy + offset0;
        float4 b = uv.xyxy + offset1;
        return 0.25 * (limn_BilinearLit(map, a.xy, z) + limn_BilinearLit(map, a.zw, z) +
                       limn_BilinearLit(map, b.xy, z) + limn_BilinearLit(map, b.zw, z));
    }
#endif
    return limn_BilinearLit(map, uv, z);
}
float limn_SampleMainLightShadowmap(float4 shadowCoord)
{
    float lit = limn_FilteredLit(_MainLightShadowmapTexture, shadowCoord.xyz,
                                 _MainLightShadowParams.y, _MainLightShadowOffset0,
                                 _MainLightShadowOffset1);
    bool isOutside = any(abs(shadowCoord.xy - 0.5) > 0.5);
    return isOutside || BEYOND_SHADOW_FAR(shadowCoord) ? 1.0
                                                       : lerp(1.0, lit, _MainLightShadowParams.x);
}
float SampleScreenSpaceShadowmap(float4 shadowCoord)
{
    float2 uv = shadowCoord.xy / max(shadowCoord.w, 0.00001);
    return _ScreenSpaceShadowmapTexture.SampleLevel(sampler_ScreenSpaceShadowmapTexture, uv, 0).x;
}

// The first sphere that holds the position, relative to limn_Origin; the number of cascades where
// none does.
float limn_CascadeIndex(float3 position)
{
    float4 center0 = _CascadeShadowSplitSpheres0;
    float4 center1 = _CascadeShadowSplitSpheres1;
    float4 center2 = _CascadeShadowSplitSpheres2;
    float4 center3 = _CascadeShadowSplitSpheres3;
    if (limn_Origin.w != 0.0)
    {
        center0 = limn_CascadeCenters[0];
        center1 = limn_CascadeCenters[1];
        center2 = limn_CascadeCenters[2];
        center3 = limn_CascadeCenters[3];
    }
    float4 distances = float4(Length2(position - center0.xyz), Length2(position - center1.xyz),
                              Length2(position - center2.xyz), Length2(position - center3.xyz));
    bool4 inside = distances < _CascadeShadowSplitSphereRadii;
    return inside.x ? 0.0 : inside.y ? 1.0 : inside.z ? 2.0 : inside.w ? 3.0 : 4.0;
}
float ComputeCascadeIndex(float3 positionWS)
{
    return limn_CascadeIndex(positionWS - limn_Origin.xyz);
}
// Of a position relative to limn_Origin, in the shadow map.
float4 limn_RelativeToShadowCoord(float3 position)
{
#ifdef _MAIN_LIGHT_SHADOWS_CASCADE
    uint cascade = (uint)limn_CascadeIndex(position);
#else
    uint cascade = 0;
#endif
    float4x4 toShadow = _MainLightWorldToShadow[cascade];
    if (limn_Origin.w != 0.0)
    {
        toShadow = limn_Moved(toShadow, limn_OriginToShadow[cascade]);
    }
    return float4(mul(toShadow, float4(position, 1.0)).xyz, 0.0);
}
float4 TransformWorldToShadowCoord(float3 positionWS)
{
#ifdef limn_ShadowsOfScreen
    return ComputeScreenPos(TransformWorldToHClip(positionWS));
#else
    return limn_RelativeToShadowCoord(positionWS - limn_Origin.xyz);
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
// Of a position relative to limn_Origin.
float limn_AdditionalLightShadow(int lightIndex, float3 position, float3 lightDirection)
{
#ifdef ADDITIONAL_LIGHT_CALCULATE_SHADOWS
    float4 params = GetAdditionalLightShadowParams(lightIndex);
    int slice = (int)params.w;
    if (slice < 0)
    {
        return 1.0;
    }
    if (params.z != 0.0)
    {
        slice += (int)CubeMapFaceID(-lightDirection);
    }
    float4x4 toShadow = _AdditionalLightsWorldToShadow[slice];
    if (limn_Origin.w != 0.0)
    {
        toShadow = limn_Moved(toShadow, limn_OriginToAdditionalShadow[slice]);
    }
    float4 shadowCoord = mul(toShadow, float4(position, 1.0));
    shadowCoord.xyz /= shadowCoord.w;
    float lit = limn_FilteredLit(_AdditionalLightsShadowmapTexture, shadowCoord.xyz, params.y,
                                 _AdditionalShadowOffset0, _AdditionalShadowOffset1);
    return BEYOND_SHADOW_FAR(shadowCoord) ? 1.0 : lerp(1.0, lit, params.x);
#else
    return 1.0;
#endif
}
float AdditionalLightRealtimeShadow(int lightIndex, float3 positionWS, float3 lightDirection)
{
    return limn_AdditionalLightShadow(lightIndex, positionWS - limn_Origin.xyz, lightDirection);
}
float AdditionalLightRealtimeShadow(int lightIndex, float3 positionWS)
{
    return AdditionalLightRealtimeShadow(lightIndex, positionWS, float3(1, 0, 0));
}

// 0 near the camera, 1 where shadows end.
float limn_ShadowFade(float3 fromCamera)
{
    return saturate(Length2(fromCamera) * _MainLightShadowParams.z + _MainLightShadowParams.w);
}
float GetMainLightShadowFade(float3 positionWS)
{
    return limn_ShadowFade(positionWS - _WorldSpaceCameraPos);
}
float GetShadowFade(float3 positionWS) { return GetMainLightShadowFade(positionWS); } // until 10
float ApplyShadowFade(float shadowAttenuation, float3 positionWS)
{
    return lerp(shadowAttenuation, 1.0, GetMainLightShadowFade(positionWS));
}
float limn_AdditionalShadowFade(float3 fromCamera)
{
    return saturate(Length2(fromCamera) * _AdditionalShadowFadeParams.x +
                    _AdditionalShadowFadeParams.y);
}
float GetAdditionalLightShadowFade(float3 positionWS)
{
    return limn_AdditionalShadowFade(positionWS - _WorldSpaceCameraPos);
}

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
    float realtime = AdditionalLightRealtimeShadow(lightIndex, positionWS, lightDirection);
#ifdef ADDITIONAL_LIGHT_CALCULATE_SHADOWS
    return MixRealtimeAndBakedShadows(realtime, 1.0, GetAdditionalLightShadowFade(positionWS));
#else
    return realtime;
#endif
}
// Of a position relative to limn_Origin.
float limn_AdditionalLightShadowRelative(int lightIndex, float3 position, float3 lightDirection)
{
    float realtime = limn_AdditionalLightShadow(lightIndex, position, lightDirection);
#ifdef ADDITIONAL_LIGHT_CALCULATE_SHADOWS
    return MixRealtimeAndBakedShadows(realtime, 1.0,
                                      limn_AdditionalShadowFade(position - limn_CameraPos.xyz));
#else
    return realtime;
#endif
}

// Moves what casts a shadow away from the light, so that it does not shadow itself. A position may be
// relative to anything.
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
#endif
