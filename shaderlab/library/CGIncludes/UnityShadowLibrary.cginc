// There are no shadow maps and no light maps: everything is lit.
#pragma once
#ifndef UNITY_BUILTIN_SHADOW_LIBRARY_INCLUDED
#define UNITY_BUILTIN_SHADOW_LIBRARY_INCLUDED
#include "UnityCG.cginc"

#define unityShadowCoord float
#define unityShadowCoord2 float2
#define unityShadowCoord3 float3
#define unityShadowCoord4 float4
#define unityShadowCoord4x4 float4x4

half UnitySampleShadowmap(float4 shadowCoord) { return 1.0; }
half UnitySampleShadowmap(float3 vec) { return 1.0; }
half UnitySampleShadowmap_PCF3x3(float4 coord, float3 receiverPlaneDepthBias) { return 1.0; }
half UnitySampleShadowmap_PCF5x5(float4 coord, float3 receiverPlaneDepthBias) { return 1.0; }
half UnitySampleShadowmap_PCF7x7(float4 coord, float3 receiverPlaneDepthBias) { return 1.0; }

fixed UnitySampleBakedOcclusion(float2 lightmapUV, float3 worldPos) { return 1.0; }
fixed4 UnityGetRawBakedOcclusions(float2 lightmapUV, float3 worldPos) { return fixed4(1, 1, 1, 1); }

// Shadows fade between the two distances that _LightShadowData has in z and w.
float UnityComputeShadowFadeDistance(float3 wpos, float z)
{
    float fromCentre = distance(wpos, unity_ShadowFadeCenterAndType.xyz);
    return lerp(z, fromCentre, unity_ShadowFadeCenterAndType.w);
}
half UnityComputeShadowFade(float fadeDist)
{
    return saturate(fadeDist * _LightShadowData.z + _LightShadowData.w);
}
half UnityMixRealtimeAndBakedShadows(half realtimeShadowAttenuation, half bakedShadowAttenuation,
                                     half fade)
{
#if defined(SHADOWS_SHADOWMASK) && !defined(LIGHTMAP_SHADOW_MIXING)
    return lerp(realtimeShadowAttenuation, bakedShadowAttenuation, fade);
#elif defined(SHADOWS_SHADOWMASK)
    return min(saturate(realtimeShadowAttenuation + fade), bakedShadowAttenuation);
#else
    return saturate(realtimeShadowAttenuation + fade);
#endif
}
#endif
