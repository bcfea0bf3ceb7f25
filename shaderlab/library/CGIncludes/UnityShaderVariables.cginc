// The built-in pipeline's names of the values that limn feeds, and those that shaders name although
// limn has no such thing: lights besides the main one, light maps, reflection probes, two eyes.
#pragma once
#ifndef UNITY_SHADER_VARIABLES_INCLUDED
#define UNITY_SHADER_VARIABLES_INCLUDED
#include "HLSLSupport.cginc"
#include "limn/PerDraw.hlsl"
// Names that only URP has are the author's own here.
#define _TimeParameters limn_TimeParameters
#define _ScaledScreenParams limn_ScaledScreenParams
#define _ScreenSize limn_ScreenSize
#define _ScaleBiasRt limn_ScaleBiasRt
#define _GlobalMipBias limn_GlobalMipBias
#include "limn/Globals.hlsl"
#undef _TimeParameters
#undef _ScaledScreenParams
#undef _ScreenSize
#undef _ScaleBiasRt
#undef _GlobalMipBias
#include "limn/RelativeSpaces.hlsl"

#if defined(DIRECTIONAL) || defined(DIRECTIONAL_COOKIE)
#define USING_DIRECTIONAL_LIGHT
#endif
#if defined(USING_DIRECTIONAL_LIGHT) || defined(POINT) || defined(SPOT) || defined(POINT_COOKIE)
#define USING_LIGHT_MULTI_COMPILE
#endif

#define _WorldSpaceLightPos0 _MainLightPosition
#define unity_IndirectSpecColor unity_AmbientSky
#define glstate_lightmodel_ambient unity_AmbientSky
#define _Object2World unity_ObjectToWorld
#define _World2Object unity_WorldToObject
#define unity_World2Shadow unity_WorldToShadow
#define unity_MatrixMVP UNITY_MATRIX_MVP

#define unity_ProbesOcclusion float4(1, 1, 1, 1)
#define unity_ProbeVolumeParams float4(0, 0, 0, 0)
static float4 unity_OcclusionMaskSelector = float4(1, 0, 0, 0); // shaders write to it
static const float4 unity_StereoScaleOffset[2] = {float4(1, 1, 0, 0), float4(1, 1, 0, 0)};

cbuffer UnityPerCameraRare
{
    float4 unity_CameraWorldClipPlanes[6]; // left, right, bottom, top, near, far
};

cbuffer UnityLighting
{
    float4 _LightPositionRange; // xyz: the place of a point light with shadows, w: 1 / range
    float4 _LightProjectionParams;
    float4 unity_4LightPosX0;
    float4 unity_4LightPosY0;
    float4 unity_4LightPosZ0;
    float4 unity_4LightAtten0;
    float4 unity_LightColor[8];
    float4 unity_LightPosition[8]; // view space; w: 0 for a direction
    float4 unity_LightAtten[8];    // x: cos(spot / 2), y: 1 / cos(spot / 4), z: quadratic falloff
    float4 unity_SpotDirection[8];
};

// The same colours by the names of Unity 4.
cbuffer UnityLightingOld
{
    half3 unity_LightColor0;
    half3 unity_LightColor1;
    half3 unity_LightColor2;
    half3 unity_LightColor3;
};

cbuffer UnityShadows
{
    float4 unity_ShadowSplitSpheres[4];
    float4 unity_ShadowSplitSqRadii;
    float4 unity_LightShadowBias;
    float4 _LightSplitsNear;
    float4 _LightSplitsFar;
    float4x4 unity_WorldToShadow[4];
    float4 _LightShadowData;
    float4 unity_ShadowFadeCenterAndType;
    float4 unity_ShadowColor;
};

cbuffer UnityLightmaps
{
    float4 unity_LightmapST;
    float4 unity_LightmapFade;
    float4 unity_DynamicLightmapST;
    float4 unity_Lightmap_HDR;
    float4 unity_DynamicLightmap_HDR;
};

cbuffer UnityReflectionProbes
{
    float4 unity_SpecCube0_BoxMax;
    float4 unity_SpecCube0_BoxMin;
    float4 unity_SpecCube0_ProbePosition;
    float4 unity_SpecCube0_HDR;
    float4 unity_SpecCube1_BoxMax;
    float4 unity_SpecCube1_BoxMin;
    float4 unity_SpecCube1_ProbePosition;
    float4 unity_SpecCube1_HDR;
};

UNITY_DECLARE_TEXCUBE(unity_SpecCube0);
UNITY_DECLARE_TEXCUBE_NOSAMPLER(unity_SpecCube1);
UNITY_DECLARE_TEX2D_HALF(unity_Lightmap);
UNITY_DECLARE_TEX2D_NOSAMPLER_HALF(unity_LightmapInd);
UNITY_DECLARE_TEX2D_HALF(unity_ShadowMask);
UNITY_DECLARE_TEX2D(unity_DynamicLightmap);
UNITY_DECLARE_TEX2D_NOSAMPLER(unity_DynamicDirectionality);
UNITY_DECLARE_TEX2D_NOSAMPLER(unity_DynamicNormal);

// These depend on the colour space in which light is added up.
#ifdef UNITY_COLORSPACE_GAMMA
#define unity_ColorSpaceGrey float4(0.5, 0.5, 0.5, 0.5)
#define unity_ColorSpaceDouble float4(2.0, 2.0, 2.0, 2.0)
#define unity_ColorSpaceDielectricSpec half4(0.220916301, 0.220916301, 0.220916301, 1.0 - 0.220916301)
#define unity_ColorSpaceLuminance half4(0.22, 0.707, 0.071, 0.0)
#else
#define unity_ColorSpaceGrey float4(0.214041144, 0.214041144, 0.214041144, 0.5)
#define unity_ColorSpaceDouble float4(4.59479380, 4.59479380, 4.59479380, 2.0)
#define unity_ColorSpaceDielectricSpec half4(0.04, 0.04, 0.04, 1.0 - 0.04)
#define unity_ColorSpaceLuminance half4(0.0396819152, 0.458021790, 0.00609653955, 1.0)
#endif
#endif
