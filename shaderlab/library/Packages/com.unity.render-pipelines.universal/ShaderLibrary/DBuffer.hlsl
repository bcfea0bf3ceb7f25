// There are no decals: surfaces stay as they are.
#pragma once
#ifndef UNIVERSAL_DBUFFER_INCLUDED
#define UNIVERSAL_DBUFFER_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceData.hlsl"

#if defined(_DBUFFER_MRT1) || defined(_DBUFFER_MRT2) || defined(_DBUFFER_MRT3)
#define _DBUFFER
#endif

#define DECLARE_DBUFFER_TEXTURE(name)
#define FETCH_DBUFFER(decal, name, positionSS)

[limn_Lacks("decals", "surfaces stay as they are")]
void ApplyDecal(float4 positionCS, inout float3 baseColor, inout float3 specularColor,
                inout float3 normalWS, inout float metallic, inout float occlusion,
                inout float smoothness)
{
}
[limn_Lacks("decals", "surfaces stay as they are")]
void ApplyDecalToBaseColor(float4 positionCS, inout float3 baseColor) {}
[limn_Lacks("decals", "surfaces stay as they are")]
void ApplyDecalToBaseColorAndNormal(float4 positionCS, inout float3 baseColor,
                                    inout float3 normalWS)
{
}
[limn_Lacks("decals", "surfaces stay as they are")]
void ApplyDecalToSurfaceData(float4 positionCS, inout SurfaceData surfaceData,
                             inout InputData inputData)
{
}
#endif
