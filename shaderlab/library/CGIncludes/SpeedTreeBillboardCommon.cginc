// Far SpeedTrees: a quad that turns about its height, with the picture from the side it is seen from.
// Scripts set its globals: limn has no billboard renderer.
#pragma once
#ifndef SPEEDTREE_BILLBOARD_COMMON_INCLUDED
#define SPEEDTREE_BILLBOARD_COMMON_INCLUDED
#include "UnityCG.cginc"
#define SPEEDTREE_ALPHATEST
fixed _Cutoff;
#include "SpeedTreeCommon.cginc"
#include "limn/SpeedTreeBillboard.hlsl"

struct SpeedTreeBillboardData
{
    float4 vertex : POSITION;
    float2 texcoord : TEXCOORD0;
    float4 texcoord1 : TEXCOORD1; // scale of width and height, rotation
    float3 normal : NORMAL;
    float4 tangent : TANGENT;
    float4 color : COLOR;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

void SpeedTreeBillboardVert(inout SpeedTreeBillboardData IN, out Input OUT)
{
    UNITY_INITIALIZE_OUTPUT(Input, OUT);
    float3 worldPos = IN.vertex.xyz + unity_ObjectToWorld._14_24_34;
    float3 tangent, normal;
    float2 uv;
    float3 offset =
        limn_PlaceBillboard(worldPos, IN.texcoord, IN.texcoord1.xyz, tangent, normal, uv);
#ifdef ENABLE_WIND
    if (_WindQuality * _WindEnabled > 0)
    {
        offset = GlobalWind(offset, worldPos, true, _ST_WindVector.xyz, IN.texcoord1.w);
    }
#endif
    IN.vertex = float4(IN.vertex.xyz + offset, 1);
    IN.normal = normal;
    IN.tangent = float4(tangent, -1);
    OUT.mainTexUV = uv;
    OUT.color = _Color;
#ifdef EFFECT_HUE_VARIATION
    OUT.HueVariationAmount = saturate(frac(dot(worldPos, 1.0)) * _HueVariation.a);
#endif
}
#endif
