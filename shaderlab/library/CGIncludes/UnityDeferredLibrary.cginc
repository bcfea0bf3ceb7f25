#pragma once
#include "UnityShadowLibrary.cginc"

UNITY_DECLARE_DEPTH_TEXTURE(_CameraDepthTexture);

cbuffer limn_DeferredLight
{
    float4 _LightDir;
    float4 _LightPos;
    float4 _LightColor;
    float _LightAsQuad; // 1: drawn as a rectangle over the screen
};

struct unity_v2f_deferred
{
    float4 pos : SV_POSITION;
    float4 uv : TEXCOORD0;
    float3 ray : TEXCOORD1; // in view space, z forward
};

struct unity_v2f_deferred_instanced
{
    float4 pos : SV_POSITION;
    float4 uv : TEXCOORD0;
    float3 ray : TEXCOORD1;
    UNITY_VERTEX_OUTPUT_STEREO
};

unity_v2f_deferred vert_deferred(float4 vertex : POSITION, float3 normal : NORMAL)
{
    unity_v2f_deferred o;
    o.pos = UnityObjectToClipPos(vertex);
    o.uv = ComputeScreenPos(o.pos);
    // A rectangle carries the corners of the far plane as its normals.
    o.ray = lerp(UnityObjectToViewPos(vertex) * float3(-1, -1, 1), normal, _LightAsQuad);
    return o;
}
