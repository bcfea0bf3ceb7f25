// Vertices of SpeedTree 6 and 7: levels of detail that blend, leaves that face the camera.
#pragma once
#ifndef SPEEDTREE_VERTEX_INCLUDED
#define SPEEDTREE_VERTEX_INCLUDED
#include "UnityCG.cginc"

// texcoord: diffuse uv, wind of the branch. texcoord1: the place at the next level of detail or, of
// leaves, their anchor and scale there. texcoord2: detail uv, or the wind's. color.a of leaves: 0 where
// they face the camera.
struct SpeedTreeVB
{
    float4 vertex : POSITION;
    float4 tangent : TANGENT;
    float3 normal : NORMAL;
    float4 texcoord : TEXCOORD0;
    float4 texcoord1 : TEXCOORD1;
    float4 texcoord2 : TEXCOORD2;
    float2 texcoord3 : TEXCOORD3;
    half4 color : COLOR;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

#ifdef ENABLE_WIND
half _WindQuality, _WindEnabled;
#endif

#include "limn/SpeedTreeWindOfTree.hlsl"
#include "limn/SpeedTree7Offset.hlsl"

void OffsetSpeedTreeVertex(inout SpeedTreeVB data, float lodValue)
{
#ifdef ENABLE_WIND
    limn_TreeWind wind = limn_WindOfTree(_WindQuality * _WindEnabled);
#else
    limn_TreeWind wind = limn_CalmTree();
#endif
    data.vertex.xyz =
        limn_OffsetTree7(wind, data.vertex.xyz, data.texcoord, data.texcoord1, data.texcoord2,
                         data.texcoord3, data.color.a, lodValue, data.normal);
}
#endif
