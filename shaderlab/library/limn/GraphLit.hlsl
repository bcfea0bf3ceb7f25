// A graph's lit surface.
#pragma once
#include "limn/GraphSurface.hlsl"

InputData limn_GraphInputData(Varyings input, SurfaceDescription surface)
{
    InputData inputData = (InputData)0;
    inputData.positionWS = input.positionWS;
    inputData.positionCS = input.positionCS;
    inputData.normalWS = limn_GraphNormal(input, surface);
#if defined(_NORMALMAP) && _NORMAL_DROPOFF_TS
    float3 bitangent = cross(input.normalWS, input.tangentWS.xyz) * input.tangentWS.w *
                       GetOddNegativeScale();
    inputData.tangentToWorld = float3x3(input.tangentWS.xyz, bitangent, input.normalWS);
#endif
    inputData.viewDirectionWS = GetWorldSpaceNormalizeViewDir(input.positionWS);
    inputData.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(input.positionCS);
    inputData.shadowMask = 1.0;
    inputData.shadowCoord = TransformWorldToShadowCoord(input.positionWS);
#if !defined(LIGHTMAP_ON)
    inputData.bakedGI = SampleSHPixel(input.sh, inputData.normalWS);
#endif
    float4 fogAndLight = input.fogFactorAndVertexLight;
    inputData.vertexLighting = fogAndLight.yzw;
    inputData.fogCoord = InitializeInputDataFog(float4(input.positionWS, 1.0), fogAndLight.x);
    return inputData;
}

SurfaceData limn_GraphSurfaceData(SurfaceDescription surface, float alpha)
{
    SurfaceData result = (SurfaceData)0;
    result.albedo = AlphaModulate(surface.BaseColor, alpha);
#ifdef _SPECULAR_SETUP
    result.specular = surface.Specular;
    result.metallic = 1.0;
#else
    result.metallic = saturate(surface.Metallic);
#endif
    result.smoothness = saturate(surface.Smoothness);
    result.occlusion = surface.Occlusion;
    result.emission = surface.Emission;
    result.alpha = saturate(alpha);
    result.clearCoatSmoothness = 1.0;
#ifdef _CLEARCOAT
    result.clearCoatMask = saturate(surface.CoatMask);
    result.clearCoatSmoothness = saturate(surface.CoatSmoothness);
#endif
    return result;
}
