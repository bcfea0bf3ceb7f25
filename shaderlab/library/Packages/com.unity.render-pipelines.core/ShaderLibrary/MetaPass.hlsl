// The pass that bakes light: it writes a surface's colour into its light map. limn bakes nothing;
// the names are there for shaders that have such a pass. The including file has the pipeline's spaces.
#pragma once
#ifndef UNITY_META_PASS_INCLUDED
#define UNITY_META_PASS_INCLUDED
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

cbuffer UnityMetaPass
{
    float4 unity_MetaVertexControl;   // x: by light map uv, y: by dynamic light map uv
    float4 unity_MetaFragmentControl; // x: albedo, y: emission
};
float unity_OneOverOutputBoost;
float unity_MaxOutputValue;
float unity_UseLinearSpace;

struct UnityMetaInput
{
    float3 Albedo;
    float3 Emission;
    float3 SpecularColor; // Shaders of URP 7 to 10 set it; nothing reads it.
};
float4 UnityMetaVertexPosition(float3 vertex, float2 uv1, float2 uv2, float4 lightmapST,
                               float4 dynlightmapST)
{
    float3 place = vertex;
    if (unity_MetaVertexControl.x != 0.0)
    {
        place = float3(uv1 * lightmapST.xy + lightmapST.zw, vertex.z > 0 ? REAL_MIN : 0.0);
    }
    if (unity_MetaVertexControl.y != 0.0)
    {
        place = float3(uv2 * dynlightmapST.xy + dynlightmapST.zw, vertex.z > 0 ? REAL_MIN : 0.0);
    }
    return TransformWorldToHClip(place);
}
float4 UnityMetaVertexPosition(float3 vertex, float2 uv1, float2 uv2)
{
    return UnityMetaVertexPosition(vertex, uv1, uv2, unity_LightmapST, unity_DynamicLightmapST);
}
float4 UnityMetaFragment(UnityMetaInput IN)
{
    float4 result = float4(0, 0, 0, 0);
    if (unity_MetaFragmentControl.x != 0.0)
    {
        float3 albedo = PositivePow(IN.Albedo, saturate(unity_OneOverOutputBoost).xxx);
        result = float4(clamp(albedo, 0.0, unity_MaxOutputValue), 1.0);
    }
    if (unity_MetaFragmentControl.y != 0.0)
    {
        result = float4(IN.Emission, 1.0);
    }
    return result;
}
#endif
