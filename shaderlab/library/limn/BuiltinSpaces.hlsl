// Positions, directions and depth of the built-in pipeline.
#pragma once
#include "limn/Screen.hlsl"

float3 UnityWorldToViewPos(float3 pos) { return limn_RelativeToView(pos - limn_Origin.xyz); }
float3 UnityObjectToViewPos(float3 pos)
{
    return limn_RelativeToView(limn_ObjectToRelative(pos));
}
float3 UnityObjectToViewPos(float4 pos) { return UnityObjectToViewPos(pos.xyz); }

float3 UnityObjectToWorldDir(float3 dir) { return normalize(mul((float3x3)unity_ObjectToWorld, dir)); }
float3 UnityWorldToObjectDir(float3 dir) { return normalize(mul((float3x3)unity_WorldToObject, dir)); }

// Normals go by the inverse transpose, so that they stay upright under uneven scale.
float3 UnityObjectToWorldNormal(float3 norm)
{
#ifdef UNITY_ASSUME_UNIFORM_SCALING
    return UnityObjectToWorldDir(norm);
#else
    return normalize(mul(norm, (float3x3)unity_WorldToObject));
#endif
}

// From a position to the light and to the camera; not normalised.
float3 UnityWorldSpaceLightDir(float3 worldPos)
{
    return _WorldSpaceLightPos0.xyz - worldPos * _WorldSpaceLightPos0.w;
}
float3 WorldSpaceLightDir(float4 localPos)
{
    return UnityWorldSpaceLightDir(mul(unity_ObjectToWorld, localPos).xyz);
}
float3 ObjSpaceLightDir(float4 v)
{
    float3 light = mul(unity_WorldToObject, _WorldSpaceLightPos0).xyz;
    return light - v.xyz * _WorldSpaceLightPos0.w;
}
float3 UnityWorldSpaceViewDir(float3 worldPos) { return _WorldSpaceCameraPos.xyz - worldPos; }
float3 WorldSpaceViewDir(float4 localPos) { return limn_ObjectToCamera(localPos.xyz); }
float3 ObjSpaceViewDir(float4 v)
{
    return mul((float3x3)unity_WorldToObject, limn_ObjectToCamera(v.xyz));
}

// Declares the matrix `rotation` from object to tangent space, out of the vertex `v`.
#define TANGENT_SPACE_ROTATION \
    float3 binormal = cross(normalize(v.normal), normalize(v.tangent.xyz)) * v.tangent.w; \
    float3x3 rotation = float3x3(v.tangent.xyz, binormal, v.normal)

// Offsets in view space become offsets in clip space.
float2 TransformViewToProjection(float2 v) { return mul((float2x2)UNITY_MATRIX_P, v); }
float3 TransformViewToProjection(float3 v) { return mul((float3x3)UNITY_MATRIX_P, v); }

float4 ComputeScreenPos(float4 pos) { return limn_ScreenPos(pos, _ProjectionParams.x); }
float4 ComputeNonStereoScreenPos(float4 pos) { return limn_ScreenPos(pos, _ProjectionParams.x); }
// Where a copy of the target's rows has the same place, whichever way up they are.
float4 ComputeGrabScreenPos(float4 pos) { return limn_ScreenPos(pos, -1.0); }

float Linear01Depth(float z) { return limn_Linear01Depth(z, _ZBufferParams); }
float LinearEyeDepth(float z) { return limn_LinearEyeDepth(z, _ZBufferParams); }

#define COMPUTE_EYEDEPTH(o) o = -UnityObjectToViewPos(v.vertex).z
#define COMPUTE_DEPTH_01 -(UnityObjectToViewPos(v.vertex).z * _ProjectionParams.w)
#define COMPUTE_VIEW_NORMAL normalize(mul((float3x3)UNITY_MATRIX_IT_MV, v.normal))
#define DECODE_EYEDEPTH(i) LinearEyeDepth(i)

// Depth that is drawn to the depth buffer and nowhere else.
#define UNITY_TRANSFER_DEPTH(oo)
#define UNITY_OUTPUT_DEPTH(i) return 0
