// A height map that shifts texture coordinates.
#pragma once

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

// Rows of the frame from tangent (w: handedness) and normal.
float3 GetViewDirectionTangentSpace(float4 tangentWS, float3 normalWS, float3 viewDirWS)
{
    float3 bitangent = cross(normalWS, tangentWS.xyz) * (tangentWS.w > 0.0 ? 1.0 : -1.0);
    float3x3 tangentToWorld = float3x3(tangentWS.xyz, bitangent, normalWS);
    return normalize(mul(tangentToWorld, viewDirWS));
}

// One step along the view direction; the offset of the direction keeps grazing views in bounds.
float2 ParallaxOffset1Step(float height, float amplitude, float3 viewDirTS)
{
    float3 v = normalize(viewDirTS);
    return (height * amplitude - amplitude * 0.5) * (v.xy / (v.z + 0.42));
}
float2 ParallaxMappingChannel(Texture2D heightMap, SamplerState heightSampler, float3 viewDirTS,
                              float scale, float2 uv, int channel)
{
    float height = heightMap.Sample(heightSampler, uv)[channel];
    return ParallaxOffset1Step(height, scale, viewDirTS);
}
float2 ParallaxMapping(Texture2D heightMap, SamplerState heightSampler, float3 viewDirTS,
                       float scale, float2 uv)
{
    return ParallaxMappingChannel(heightMap, heightSampler, viewDirTS, scale, uv, 1);
}
