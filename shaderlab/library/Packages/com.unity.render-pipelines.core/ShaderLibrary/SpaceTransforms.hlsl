// OS, WS, VS, CS: object, world, view and clip space. View space looks down -z.
#pragma once
#ifndef UNITY_SPACE_TRANSFORMS_INCLUDED
#define UNITY_SPACE_TRANSFORMS_INCLUDED
// Forks of the universal package come without limn's UnityInput.hlsl.
#include "limn/PerDraw.hlsl"
#include "limn/Globals.hlsl"
#include "limn/RelativeSpaces.hlsl"

float4x4 GetObjectToWorldMatrix() { return UNITY_MATRIX_M; }
float4x4 GetWorldToObjectMatrix() { return UNITY_MATRIX_I_M; }
float4x4 GetWorldToViewMatrix() { return UNITY_MATRIX_V; }
float4x4 GetViewToWorldMatrix() { return UNITY_MATRIX_I_V; }
float4x4 GetWorldToHClipMatrix() { return UNITY_MATRIX_VP; }
float4x4 GetViewToHClipMatrix() { return UNITY_MATRIX_P; }

float4x4 GetPrevObjectToWorldMatrix() { return UNITY_PREV_MATRIX_M; }
float4x4 GetPrevWorldToObjectMatrix() { return UNITY_PREV_MATRIX_I_M; }

// Positions are not relative to the camera.
float3 GetAbsolutePositionWS(float3 positionRWS) { return positionRWS; }
float3 GetCameraRelativePositionWS(float3 positionWS) { return positionWS; }

// -1 where the object is mirrored
float GetOddNegativeScale() { return unity_WorldTransformParams.w >= 0.0 ? 1.0 : -1.0; }

float3 TransformObjectToWorld(float3 positionOS)
{
    return mul(GetObjectToWorldMatrix(), float4(positionOS, 1.0)).xyz;
}
float3 TransformWorldToObject(float3 positionWS)
{
    return mul(GetWorldToObjectMatrix(), float4(positionWS, 1.0)).xyz;
}
float3 TransformWorldToView(float3 positionWS)
{
    return limn_RelativeToView(positionWS - limn_Origin.xyz);
}
float3 TransformViewToWorld(float3 positionVS)
{
    return mul(GetViewToWorldMatrix(), float4(positionVS, 1.0)).xyz;
}
float4 TransformWorldToHClip(float3 positionWS)
{
    return limn_RelativeToClip(positionWS - limn_Origin.xyz);
}
float4 TransformWViewToHClip(float3 positionVS)
{
    return mul(GetViewToHClipMatrix(), float4(positionVS, 1.0));
}
float4 TransformObjectToHClip(float3 positionOS)
{
    return limn_RelativeToClip(limn_ObjectToRelative(positionOS));
}

float3 limn_NormalizeIf(float3 v, bool doNormalize) { return doNormalize ? SafeNormalize(v) : v; }

float3 TransformObjectToWorldDir(float3 dirOS, bool doNormalize = true)
{
    return limn_NormalizeIf(mul((float3x3)GetObjectToWorldMatrix(), dirOS), doNormalize);
}
float3 TransformWorldToObjectDir(float3 dirWS, bool doNormalize = true)
{
    return limn_NormalizeIf(mul((float3x3)GetWorldToObjectMatrix(), dirWS), doNormalize);
}
float3 TransformWorldToViewDir(float3 dirWS, bool doNormalize = false)
{
    return limn_NormalizeIf(mul((float3x3)GetWorldToViewMatrix(), dirWS), doNormalize);
}
float3 TransformViewToWorldDir(float3 dirVS, bool doNormalize = false)
{
    return limn_NormalizeIf(mul((float3x3)GetViewToWorldMatrix(), dirVS), doNormalize);
}
float3 TransformWorldToHClipDir(float3 dirWS, bool doNormalize = false)
{
    return limn_NormalizeIf(mul((float3x3)GetWorldToHClipMatrix(), dirWS), doNormalize);
}

// Normals go by the inverse transpose, so that they stay upright under uneven scale.
float3 TransformObjectToWorldNormal(float3 normalOS, bool doNormalize = true)
{
#ifdef UNITY_ASSUME_UNIFORM_SCALING
    return TransformObjectToWorldDir(normalOS, doNormalize);
#else
    return limn_NormalizeIf(mul(normalOS, (float3x3)GetWorldToObjectMatrix()), doNormalize);
#endif
}
float3 TransformWorldToObjectNormal(float3 normalWS, bool doNormalize = true)
{
#ifdef UNITY_ASSUME_UNIFORM_SCALING
    return TransformWorldToObjectDir(normalWS, doNormalize);
#else
    return limn_NormalizeIf(mul(normalWS, (float3x3)GetObjectToWorldMatrix()), doNormalize);
#endif
}
// The view matrix only turns and moves: directions and normals go alike.
float3 TransformWorldToViewNormal(float3 normalWS, bool doNormalize = false)
{
    return TransformWorldToViewDir(normalWS, doNormalize);
}
float3 TransformViewToWorldNormal(float3 normalVS, bool doNormalize = false)
{
    return TransformViewToWorldDir(normalVS, doNormalize);
}

// Rows: tangent, bitangent, normal
float3x3 CreateTangentToWorld(float3 normal, float3 tangent, float flipSign)
{
    float3 bitangent = cross(normal, tangent) * (flipSign * GetOddNegativeScale());
    return float3x3(tangent, bitangent, normal);
}
float3 TransformTangentToWorld(float3 v, float3x3 tangentToWorld, bool doNormalize = false)
{
    return limn_NormalizeIf(mul(v, tangentToWorld), doNormalize);
}
// HLSL cuts a 4x4 argument down to 3x3 by itself; glslang does not.
float3 TransformTangentToWorld(float3 v, float4x4 tangentToWorld, bool doNormalize = false)
{
    return TransformTangentToWorld(v, (float3x3)tangentToWorld, doNormalize);
}
float3 TransformTangentToWorldDir(float3 v, float3x3 tangentToWorld, bool doNormalize = false)
{
    return TransformTangentToWorld(v, tangentToWorld, doNormalize);
}
// The inverse of TransformTangentToWorld for an orthonormal frame
float3 TransformWorldToTangentDir(float3 v, float3x3 tangentToWorld, bool doNormalize = false)
{
    return limn_NormalizeIf(mul(tangentToWorld, v), doNormalize);
}
// The inverse of TransformTangentToWorld for any frame that has one, as interpolated ones need it
float3 TransformWorldToTangent(float3 v, float3x3 tangentToWorld, bool doNormalize = true)
{
    float3 t = tangentToWorld[0];
    float3 b = tangentToWorld[1];
    float3 n = tangentToWorld[2];
    float3 scaled = float3(dot(cross(b, n), v), dot(cross(n, t), v), dot(cross(t, b), v));
    float determinant = dot(t, cross(b, n)); // Cramer's rule
    return doNormalize ? SafeNormalize(determinant < 0.0 ? -scaled : scaled) : scaled / determinant;
}
float3 TransformTangentToObject(float3 v, float3x3 tangentToWorld)
{
    return TransformWorldToObjectDir(mul(v, tangentToWorld));
}
float3 TransformObjectToTangent(float3 v, float3x3 tangentToWorld)
{
    return TransformWorldToTangent(TransformObjectToWorldDir(v), tangentToWorld);
}
#endif
