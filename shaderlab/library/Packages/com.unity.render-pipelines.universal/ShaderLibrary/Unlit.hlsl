#pragma once
#ifndef UNIVERSAL_UNLIT_INCLUDED
#define UNIVERSAL_UNLIT_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"

// The colour as it is, brightened by emission.
float4 UniversalFragmentUnlit(InputData inputData, SurfaceData surfaceData)
{
    float3 albedo = surfaceData.albedo;
#ifdef _SCREEN_SPACE_OCCLUSION
    float2 uv = inputData.normalizedScreenSpaceUV;
    albedo *= GetScreenSpaceAmbientOcclusion(uv).directAmbientOcclusion;
#endif
    return float4(albedo + surfaceData.emission, surfaceData.alpha);
}
float4 UniversalFragmentUnlit(InputData inputData, float3 color, float alpha)
{
    SurfaceData surfaceData = (SurfaceData)0;
    surfaceData.albedo = color;
    surfaceData.alpha = alpha;
    surfaceData.occlusion = 1.0;
    surfaceData.clearCoatSmoothness = 1.0;
    return UniversalFragmentUnlit(inputData, surfaceData);
}
#endif
