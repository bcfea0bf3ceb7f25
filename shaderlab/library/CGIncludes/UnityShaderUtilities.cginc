#pragma once
#ifndef UNITY_SHADER_UTILITIES_INCLUDED
#define UNITY_SHADER_UTILITIES_INCLUDED
#include "UnityShaderVariables.cginc"

float4 UnityWorldToClipPos(float3 pos) { return limn_RelativeToClip(pos - limn_Origin.xyz); }
float4 UnityViewToClipPos(float3 pos) { return mul(UNITY_MATRIX_P, float4(pos, 1.0)); }
float4 UnityObjectToClipPos(float3 pos)
{
    return limn_RelativeToClip(limn_ObjectToRelative(pos));
}
float4 UnityObjectToClipPos(float4 pos) { return UnityObjectToClipPos(pos.xyz); }
float4 UnityObjectToClipPosInstanced(float3 pos) { return UnityObjectToClipPos(pos); }
float4 UnityObjectToClipPosInstanced(float4 pos) { return UnityObjectToClipPos(pos.xyz); }
float4 UnityObjectToClipPosODS(float3 pos) { return UnityObjectToClipPos(pos); }
#endif
