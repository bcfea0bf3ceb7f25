// Passes with LightMode Meta tell a light baker what a surface gives off. limn bakes nothing: they
// compile, and are not drawn.
#pragma once
#ifndef UNITY_META_PASS_INCLUDED
#define UNITY_META_PASS_INCLUDED
#include "UnityCG.cginc"

cbuffer UnityMetaPass
{
    float4 unity_MetaVertexControl;   // x: place by light map coordinates, y: by those of dynamic ones
    float4 unity_MetaFragmentControl; // x: albedo is asked for, y: emission
    float unity_OneOverOutputBoost;
    float unity_MaxOutputValue;
    float unity_UseLinearSpace;
};

struct UnityMetaInput
{
    half3 Albedo;
    half3 Emission;
    half3 SpecularColor;
};

// A coordinate of a light map as a position of the picture; z stays off the near plane.
float4 UnityMetaVertexPosition(float4 vertex, float2 uv1, float2 uv2, float4 lightmapST,
                               float4 dynlightmapST)
{
    // x asks for the static light map, y for the dynamic one, which comes first.
    bool2 wanted = unity_MetaVertexControl.xy != 0.0;
    float2 onMap = wanted.y ? uv2 * dynlightmapST.xy + dynlightmapST.zw
                            : uv1 * lightmapST.xy + lightmapST.zw;
    float3 place = vertex.xyz;
    if (wanted.x || wanted.y)
    {
        place = float3(onMap, place.z > 0 ? 1.0e-4 : 0.0);
    }
    return UnityWorldToClipPos(place);
}

float2 UnityMetaVizUV(int uvIndex, float2 uv0, float2 uv1, float2 uv2, float4 st)
{
    return (uvIndex == 0 ? uv0 : uvIndex == 1 ? uv1 : uv2) * st.xy + st.zw;
}

half4 UnityMetaFragment(UnityMetaInput IN)
{
    half4 result = half4(0, 0, 0, 0);
    if (unity_MetaFragmentControl.x != 0.0)
    {
        half3 boosted = pow(max(IN.Albedo, 0.0), saturate(unity_OneOverOutputBoost));
        result = half4(clamp(boosted, 0.0, unity_MaxOutputValue), 1.0);
    }
    if (unity_MetaFragmentControl.y != 0.0)
    {
        half3 emission = unity_UseLinearSpace != 0.0 ? IN.Emission : GammaToLinearSpace(IN.Emission);
        result = half4(emission, 1.0);
    }
    return result;
}
#endif
