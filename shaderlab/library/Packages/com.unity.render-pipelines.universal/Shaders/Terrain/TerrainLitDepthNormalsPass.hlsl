// Depth, and world-space normals of URP's terrain in a colour target.
#pragma once
#define UNIVERSAL_FORWARD_LIT_DEPTH_NORMALS_PASS_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/Shaders/Terrain/TerrainLitPasses.hlsl"

struct AttributesDepthNormal
{
    float4 positionOS : POSITION;
    float3 normalOS : NORMAL;
    float2 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct VaryingsDepthNormal
{
    float4 uvMainAndLM : TEXCOORD0;
    float4 uvSplat01 : TEXCOORD1;
    float4 uvSplat23 : TEXCOORD2;
#ifdef _NORMALMAP
    half4 normal : TEXCOORD3;
    half4 tangent : TEXCOORD4;
    half4 bitangent : TEXCOORD5;
#else
    half3 normal : TEXCOORD3;
#endif
    float4 clipPos : SV_POSITION;
    UNITY_VERTEX_OUTPUT_STEREO
};

VaryingsDepthNormal DepthNormalOnlyVertex(AttributesDepthNormal v)
{
    Attributes whole = (Attributes)0;
    whole.positionOS = v.positionOS;
    whole.normalOS = v.normalOS;
    whole.texcoord = v.texcoord;
    Varyings all = SplatmapVert(whole);

    VaryingsDepthNormal o = (VaryingsDepthNormal)0;
    o.clipPos = all.clipPos;
    o.uvMainAndLM = all.uvMainAndLM;
#ifndef TERRAIN_SPLAT_BASEPASS
    o.uvSplat01 = all.uvSplat01;
    o.uvSplat23 = all.uvSplat23;
#endif
    o.normal = all.normal;
#ifdef _NORMALMAP
    o.tangent = all.tangent;
    o.bitangent = all.bitangent;
#endif
    return o;
}

void DepthNormalOnlyFragment(VaryingsDepthNormal IN, out half4 outNormalWS : SV_Target0)
{
#ifdef _ALPHATEST_ON
    ClipHoles(IN.uvMainAndLM.xy);
#endif
    half3 normalWS = IN.normal.xyz;
#if defined(_NORMALMAP) && !defined(TERRAIN_SPLAT_BASEPASS)
    half4 control = limn_TerrainControl(IN.uvMainAndLM.xy);
    half3 normalTS = half3(0, 0, 1);
    NormalMapMix(IN.uvSplat01, IN.uvSplat23, control, normalTS);
    half3x3 frame = half3x3(-IN.tangent.xyz, IN.bitangent.xyz, normalWS);
    normalWS = TransformTangentToWorld(normalTS, frame);
#endif
    outNormalWS = half4(NormalizeNormalPerPixel(normalWS), 0.0);
}
