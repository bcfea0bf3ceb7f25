// There are no decals: surfaces stay as they are.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceData.hlsl"

#define DECLARE_DBUFFER_TEXTURE(name)
#define FETCH_DBUFFER(decal, name, positionSS)

void ApplyDecal(float4 positionCS, inout float3 baseColor, inout float3 specularColor,
                inout float3 normalWS, inout float metallic, inout float occlusion,
                inout float smoothness)
{
}
void ApplyDecalToBaseColor(float4 positionCS, inout float3 baseColor) {}
void ApplyDecalToBaseColorAndNormal(float4 positionCS, inout float3 baseColor,
                                    inout float3 normalWS)
{
}
void ApplyDecalToSurfaceData(float4 positionCS, inout SurfaceData surfaceData,
                             inout InputData inputData)
{
}
