#pragma once
#ifndef UNITY_SHADER_VARIABLES_FUNCTIONS_INCLUDED
#define UNITY_SHADER_VARIABLES_FUNCTIONS_INCLUDED
#include "limn/Globals.hlsl"

// Texture coordinate of the screen, times w. v runs down from the top, as rows of textures do.
float4 ComputeScreenPos(float4 positionCS)
{
    return limn_ScreenPos(positionCS, _ProjectionParams.x);
}

VertexPositionInputs GetVertexPositionInputs(float3 positionOS)
{
    VertexPositionInputs input;
    input.positionWS = TransformObjectToWorld(positionOS);
    input.positionVS = limn_RelativeToView(limn_ObjectToRelative(positionOS));
    input.positionCS = TransformObjectToHClip(positionOS);
    input.positionNDC = ComputeScreenPos(input.positionCS);
    return input;
}

VertexNormalInputs GetVertexNormalInputs(float3 normalOS)
{
    VertexNormalInputs result;
    result.tangentWS = float3(1, 0, 0);
    result.bitangentWS = float3(0, 1, 0);
    result.normalWS = TransformObjectToWorldNormal(normalOS);
    return result;
}

VertexNormalInputs GetVertexNormalInputs(float3 normalOS, float4 tangentOS)
{
    VertexNormalInputs result;
    result.normalWS = TransformObjectToWorldNormal(normalOS);
    result.tangentWS = TransformObjectToWorldDir(tangentOS.xyz);
    result.bitangentWS =
        cross(result.normalWS, result.tangentWS) * (tangentOS.w * GetOddNegativeScale());
    return result;
}

float4 GetScaledScreenParams() { return _ScaledScreenParams; }

// Texture coordinate of the screen from SV_Position.
float2 GetNormalizedScreenSpaceUV(float2 positionCS)
{
    float2 uv = positionCS * rcp(GetScaledScreenParams().xy);
    return float2(uv.x, 1.0 - (uv.y * _ScaleBiasRt.x + _ScaleBiasRt.y));
}
float2 GetNormalizedScreenSpaceUV(float4 positionCS)
{
    return GetNormalizedScreenSpaceUV(positionCS.xy);
}

bool IsPerspectiveProjection() { return unity_OrthoParams.w == 0.0; }
float3 GetCameraPositionWS() { return _WorldSpaceCameraPos; }
float3 GetPrimaryCameraPosition() { return _WorldSpaceCameraPos; }
float3 GetCurrentViewPosition() { return _WorldSpaceCameraPos; }
float3 GetViewForwardDir() { return -UNITY_MATRIX_V[2].xyz; }

// From the surface to the camera; not normalised for a perspective camera.
float3 GetWorldSpaceViewDir(float3 positionWS)
{
    return IsPerspectiveProjection() ? GetCurrentViewPosition() - positionWS : -GetViewForwardDir();
}
float3 GetWorldSpaceNormalizeViewDir(float3 positionWS)
{
    return SafeNormalize(GetWorldSpaceViewDir(positionWS));
}
// The same from where a point of the object is, exact also far away from the world's origin.
float3 limn_ObjectToWorldSpaceViewDir(float3 positionOS)
{
    return IsPerspectiveProjection() ? limn_ObjectToCamera(positionOS) : -GetViewForwardDir();
}
float3 GetObjectSpaceNormalizeViewDir(float3 positionOS)
{
    return SafeNormalize(
        TransformWorldToObjectDir(limn_ObjectToWorldSpaceViewDir(positionOS), false));
}

// Where there is no normal, it is 0: light then gives nothing.
float3 NormalizeNormalPerVertex(float3 normalWS) { return SafeNormalize(normalWS); }
float3 NormalizeNormalPerPixel(float3 normalWS) { return SafeNormalize(normalWS); }

// Distance along the view axis of an orthographic camera.
float LinearDepthToEyeDepth(float rawDepth)
{
    return _ProjectionParams.z -
           (_ProjectionParams.z - _ProjectionParams.y) * limn_Nearness(rawDepth);
}

float AlphaDiscard(float alpha, float cutoff, float offset = 0.0)
{
#ifdef _ALPHATEST_ON
    clip(alpha - cutoff + offset);
#endif
    return alpha;
}

float AlphaClip(float alpha, float cutoff)
{
    clip(alpha - cutoff + 0.0001);
    return alpha;
}
bool IsAlphaDiscardEnabled()
{
#ifdef _ALPHATEST_ON
    return true;
#else
    return false;
#endif
}
static const float kSurfaceTypeOpaque = 0.0;
static const float kSurfaceTypeTransparent = 1.0;
bool IsSurfaceTypeTransparent(float surfaceType) { return surfaceType == kSurfaceTypeTransparent; }
bool IsSurfaceTypeOpaque(float surfaceType) { return surfaceType == kSurfaceTypeOpaque; }
bool IsSurfaceTypeTransparent()
{
#ifdef _SURFACE_TYPE_TRANSPARENT
    return true;
#else
    return false;
#endif
}
// What is not transparent covers all that is behind it.
float OutputAlpha(float alpha, bool isTransparent) { return isTransparent ? alpha : 1.0; }
float OutputAlpha(float outputAlpha, float surfaceType = 1.0)
{
    return IsSurfaceTypeTransparent(surfaceType) ? outputAlpha : 1.0;
}
// Multiplicative blending fades to white.
float3 AlphaModulate(float3 albedo, float alpha)
{
#ifdef _ALPHAMODULATE_ON
    return lerp(float3(1, 1, 1), albedo, alpha);
#else
    return albedo;
#endif
}
float3 AlphaPremultiply(float3 albedo, float alpha)
{
#ifdef _ALPHAPREMULTIPLY_ON
    return albedo * alpha;
#else
    return albedo;
#endif
}

// Rendering layer bits of the object, and the same in one channel of 8 bits.
uint GetMeshRenderingLayer() { return asuint(unity_RenderingLayer.x); }
float EncodeMeshRenderingLayer(uint renderingLayer) { return (renderingLayer & 0xFFu) / 255.0; }
uint DecodeMeshRenderingLayer(float value) { return (uint)(value * 255.0 + 0.5); }

// Fog by distance along the view axis; the keyword chooses the curve.
float ComputeFogFactorZ0ToFar(float z)
{
#if defined(FOG_LINEAR)
    return saturate(z * unity_FogParams.z + unity_FogParams.w);
#elif defined(FOG_EXP) || defined(FOG_EXP2)
    return unity_FogParams.x * z;
#else
    return 0.0;
#endif
}
float ComputeFogFactor(float clipZ)
{
    return ComputeFogFactorZ0ToFar(limn_DistanceFromClipZ(clipZ, _ProjectionParams));
}
float ComputeFogIntensity(float fogFactor)
{
#if defined(FOG_EXP)
    return saturate(exp2(-fogFactor));
#elif defined(FOG_EXP2)
    return saturate(exp2(-fogFactor * fogFactor));
#elif defined(FOG_LINEAR)
    return fogFactor;
#else
    return 1.0;
#endif
}
float3 MixFogColor(float3 color, float3 fogColor, float fogFactor)
{
    return lerp(fogColor, color, ComputeFogIntensity(fogFactor));
}
float3 MixFog(float3 color, float fogFactor)
{
    return MixFogColor(color, unity_FogColor.rgb, fogFactor);
}

// Where _FOG_FRAGMENT is set by the view depth of the pixel, else what the vertex function worked
// out.
float InitializeInputDataFog(float4 positionWS, float vertFogFactor)
{
#if defined(_FOG_FRAGMENT) && (defined(FOG_LINEAR) || defined(FOG_EXP) || defined(FOG_EXP2))
    float viewZ = -TransformWorldToView(positionWS.xyz).z;
    return ComputeFogFactorZ0ToFar(max(viewZ - _ProjectionParams.y, 0.0));
#else
    return vertFogFactor;
#endif
}

void TransformScreenUV(inout float2 uv, float screenHeight) {}
void TransformScreenUV(inout float2 uv) {}
#ifndef TransformStereoScreenSpaceTex // a macro in HLSLSupport.cginc
float2 TransformStereoScreenSpaceTex(float2 uv, float w) { return uv; }
#endif

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/ShaderVariablesFunctions.deprecated.hlsl"
#endif
