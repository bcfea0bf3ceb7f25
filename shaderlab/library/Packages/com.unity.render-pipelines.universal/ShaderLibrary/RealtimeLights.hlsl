// The main light, and lights besides it.
#pragma once
#ifndef UNIVERSAL_REALTIME_LIGHTS_INCLUDED
#define UNIVERSAL_REALTIME_LIGHTS_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonLighting.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/AmbientOcclusion.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/LightCookie/LightCookie.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Clustering.hlsl"

struct Light
{
    float3 direction; // to the light
    float3 color;
    float distanceAttenuation;
    float shadowAttenuation;
    uint layerMask;
};

#define LIGHT_LOOP_BEGIN(lightCount) \
    for (uint lightIndex = 0u; lightIndex < (uint)(lightCount); ++lightIndex) \
    {
#define LIGHT_LOOP_END }

// Karis 2013: the inverse square law, brought to 0 at the range; xy: 1/range^2, -
float DistanceAttenuation(float distanceSqr, float2 distanceAttenuation)
{
    float window = saturate(1.0 - Sq(distanceSqr * distanceAttenuation.x));
    return Sq(window) / distanceSqr;
}
// xy: 1/(cos inner - cos outer), -cos outer/(cos inner - cos outer)
float AngleAttenuation(float3 spotDirection, float3 lightDirection, float2 spotAttenuation)
{
    float cosine = dot(spotDirection, lightDirection);
    float cone = saturate(cosine * spotAttenuation.x + spotAttenuation.y);
    return cone * cone;
}

Light GetMainLight()
{
    Light light;
    light.direction = _MainLightPosition.xyz;
    light.color = _MainLightColor.rgb;
    light.distanceAttenuation = 1.0;
    light.shadowAttenuation = 1.0;
#ifdef _LIGHT_LAYERS
    light.layerMask = _MainLightLayerMask;
#else
    light.layerMask = 0xFFFFFFFFu;
#endif
    return light;
}
Light GetMainLight(float4 shadowCoord)
{
    Light light = GetMainLight();
    light.shadowAttenuation = MainLightRealtimeShadow(shadowCoord);
    return light;
}
Light GetMainLight(float4 shadowCoord, float3 positionWS, float4 shadowMask)
{
    Light light = GetMainLight();
    light.shadowAttenuation =
        MainLightShadow(shadowCoord, positionWS, shadowMask, _MainLightOcclusionProbes);
#ifdef _LIGHT_COOKIES
    light.color *= SampleMainLightCookie(positionWS);
#endif
    return light;
}
Light GetMainLight(InputData inputData, float4 shadowMask, AmbientOcclusionFactor aoFactor)
{
    Light light = GetMainLight(inputData.shadowCoord, inputData.positionWS, shadowMask);
#if defined(_SCREEN_SPACE_OCCLUSION) && !defined(_SURFACE_TYPE_TRANSPARENT)
    light.color *= aoFactor.directAmbientOcclusion;
#endif
    return light;
}

// _AdditionalLightsAttenuation: xy of DistanceAttenuation, zw of AngleAttenuation.
Light limn_AdditionalLight(int perObjectLightIndex, float3 toLight)
{
    float4 attenuation = _AdditionalLightsAttenuation[perObjectLightIndex];
    float distanceSqr = max(dot(toLight, toLight), HALF_MIN);

    Light light;
    light.direction = toLight * rsqrt(distanceSqr);
    light.color = _AdditionalLightsColor[perObjectLightIndex].rgb;
    light.distanceAttenuation =
        DistanceAttenuation(distanceSqr, attenuation.xy) *
        AngleAttenuation(_AdditionalLightsSpotDir[perObjectLightIndex].xyz, light.direction,
                         attenuation.zw);
    light.shadowAttenuation = 1.0;
#ifdef _LIGHT_LAYERS
    light.layerMask = _AdditionalLightsLayerMasks[perObjectLightIndex];
#else
    light.layerMask = 0xFFFFFFFFu;
#endif
    return light;
}

Light GetAdditionalPerObjectLight(int perObjectLightIndex, float3 positionWS)
{
    float4 position = _AdditionalLightsPosition[perObjectLightIndex];
    return limn_AdditionalLight(perObjectLightIndex, position.xyz - positionWS * position.w);
}
int GetPerObjectLightIndex(uint index)
{
    return (int)unity_LightIndices[index >> 2u][index & 3u];
}
// Of a position relative to limn_Origin: as exact far away from the world's origin as near it.
Light limn_GetAdditionalLightRelative(uint i, float3 position)
{
    int index = GetPerObjectLightIndex(i);
    float4 light = limn_AdditionalLightsPosition[index];
    Light seen = limn_AdditionalLight(index, light.xyz - position * light.w);
    seen.shadowAttenuation =
        limn_AdditionalLightShadowRelative(index, position, seen.direction);
    return seen;
}

int GetAdditionalLightsCount() { return (int)min(_AdditionalLightsCount.x, unity_LightData.y); }

Light GetAdditionalLight(uint i, float3 positionWS)
{
    return GetAdditionalPerObjectLight(GetPerObjectLightIndex(i), positionWS);
}
Light GetAdditionalLight(uint i, float3 positionWS, float4 shadowMask)
{
    int index = GetPerObjectLightIndex(i);
    Light light = GetAdditionalPerObjectLight(index, positionWS);
    light.shadowAttenuation =
        AdditionalLightShadow(index, positionWS, light.direction, shadowMask,
                              _AdditionalLightsOcclusionProbes[index]);
#ifdef _LIGHT_COOKIES
    light.color *= SampleAdditionalLightCookie(index, positionWS);
#endif
    return light;
}
Light GetAdditionalLight(uint i, InputData inputData, float4 shadowMask,
                         AmbientOcclusionFactor aoFactor)
{
    Light light = GetAdditionalLight(i, inputData.positionWS, shadowMask);
#if defined(_SCREEN_SPACE_OCCLUSION) && !defined(_SURFACE_TYPE_TRANSPARENT)
    light.color *= aoFactor.directAmbientOcclusion;
#endif
    return light;
}

float4 CalculateShadowMask(InputData inputData) { return float4(1, 1, 1, 1); }
#endif
