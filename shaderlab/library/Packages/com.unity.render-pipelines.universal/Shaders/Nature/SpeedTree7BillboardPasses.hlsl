// Passes of the billboards of SpeedTree 7.
#pragma once
#ifndef UNIVERSAL_SPEEDTREE7BILLBOARD_PASSES_INCLUDED
#define UNIVERSAL_SPEEDTREE7BILLBOARD_PASSES_INCLUDED
#include "SpeedTree7CommonPasses.hlsl"

void InitializeData(inout SpeedTreeVertexInput input, out half2 outUV, out half outHueVariation)
{
    float3 worldPos = input.vertex.xyz + UNITY_MATRIX_M._14_24_34;
    float3 tangent, normal;
    float2 uv;
    float3 offset = limn_PlaceBillboard(worldPos, input.texcoord.xy, input.texcoord1.xyz, tangent,
                                        normal, uv);
#ifdef ENABLE_WIND
    if (_WindQuality * _WindEnabled > 0)
    {
        offset = GlobalWind(offset, worldPos, true, _ST_WindVector.xyz, input.texcoord1.w);
    }
#endif
    input.vertex = float4(input.vertex.xyz + offset, 1.0);
    input.normal = normal;
    input.tangent = float4(tangent, -1);
    outUV = uv;
#ifdef EFFECT_HUE_VARIATION
    outHueVariation = saturate(frac(dot(worldPos, 1.0)) * _HueVariation.a);
#else
    outHueVariation = 0;
#endif
}
half3 limn_InitializeBillboard(inout SpeedTreeVertexInput input)
{
    half2 uv;
    half hue;
    InitializeData(input, uv, hue);
    return half3(uv, hue);
}

SpeedTreeVertexOutput SpeedTree7Vert(SpeedTreeVertexInput input)
{
    SpeedTreeVertexOutput output = (SpeedTreeVertexOutput)0;
    UNITY_SETUP_INSTANCE_ID(input);
    output.uvHueVariation = limn_InitializeBillboard(input);
#ifdef VERTEX_COLOR
    output.color = _Color;
#endif
    limn_TREE_TRANSFER_LIT(input, output)
    return output;
}
SpeedTreeVertexDepthOutput SpeedTree7VertDepth(SpeedTreeVertexInput input)
{
    SpeedTreeVertexDepthOutput output = (SpeedTreeVertexDepthOutput)0;
    UNITY_SETUP_INSTANCE_ID(input);
    output.uvHueVariation = limn_InitializeBillboard(input);
    limn_TREE_TRANSFER_DEPTH(input, output)
    return output;
}
SpeedTreeVertexDepthNormalOutput SpeedTree7VertDepthNormalBillboard(SpeedTreeVertexInput input)
{
    SpeedTreeVertexDepthNormalOutput output = (SpeedTreeVertexDepthNormalOutput)0;
    UNITY_SETUP_INSTANCE_ID(input);
    output.uvHueVariation = limn_InitializeBillboard(input);
    limn_TREE_TRANSFER_DEPTH_NORMAL(input, output)
    return output;
}
half4 SpeedTree7FragDepthNormalBillboard(SpeedTreeVertexDepthNormalOutput input) : SV_Target
{
    return SpeedTree7FragDepthNormal(input);
}
#endif
