// Names that Unity feeds: those that limn feeds too, and constants for what it does not have (light
// maps, probes besides the ambient light, motion, a second eye).
#pragma once
#ifndef UNIVERSAL_SHADER_VARIABLES_INCLUDED
#define UNIVERSAL_SHADER_VARIABLES_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "limn/PerDraw.hlsl"
#include "limn/Globals.hlsl"
#include "limn/RelativeSpaces.hlsl"

#define unity_LightmapST float4(1, 1, 0, 0)
#define unity_DynamicLightmapST float4(1, 1, 0, 0)
#define unity_ProbesOcclusion float4(1, 1, 1, 1)
#define unity_SpecCube1_HDR float4(1, 1, 0, 0)
#define unity_SpecCube0_BoxMax float4(0, 0, 0, 0)
#define unity_SpecCube0_BoxMin float4(0, 0, 0, 1)
#define unity_SpecCube0_ProbePosition float4(0, 0, 0, 0)
#define unity_SpecCube1_BoxMax float4(0, 0, 0, 0)
#define unity_SpecCube1_BoxMin float4(0, 0, 0, 0)
#define unity_SpecCube1_ProbePosition float4(0, 0, 0, 0)
#define unity_MatrixPreviousM unity_ObjectToWorld
#define unity_MatrixPreviousMI unity_WorldToObject
#define unity_MotionVectorsParams float4(0, 0, 0, 1)
#define unity_RendererBounds_Min float4(0, 0, 0, 0)
#define unity_RendererBounds_Max float4(0, 0, 0, 0)
#ifdef UNITY_COLORSPACE_GAMMA
#define unity_ColorSpaceDouble float4(2.0, 2.0, 2.0, 2.0)
#else
#define unity_ColorSpaceDouble float4(4.59479380, 4.59479380, 4.59479380, 2.0)
#endif
#define UNITY_PREV_MATRIX_M unity_MatrixPreviousM
#define UNITY_PREV_MATRIX_I_M unity_MatrixPreviousMI
#define _LastTimeParameters _TimeParameters

// Which of the additional lights an object has.
cbuffer limn_ObjectLights
{
    float4 limn_LightCount; // x; 0 where nothing sets it
    float4 unity_LightIndices[2];
};
// z: the main light lights it
#define unity_LightData float4(0, limn_LightCount.x, 1, 0)

// How the sky's reflection is decoded, by DecodeHDREnvironment.
cbuffer limn_Reflections
{
    float4 unity_SpecCube0_HDR;
    float4 _GlossyEnvironmentCubeMap_HDR;
};

TEXTURECUBE(unity_SpecCube0);
SAMPLER(samplerunity_SpecCube0);
TEXTURECUBE(unity_SpecCube1);
SAMPLER(samplerunity_SpecCube1);
TEXTURECUBE(_GlossyEnvironmentCubeMap);
SAMPLER(sampler_GlossyEnvironmentCubeMap);
TEXTURE2D(unity_Lightmap);
SAMPLER(samplerunity_Lightmap);
TEXTURE2D(unity_LightmapInd);
TEXTURE2D(unity_DynamicLightmap);
SAMPLER(samplerunity_DynamicLightmap);
TEXTURE2D(unity_DynamicDirectionality);
TEXTURE2D(unity_ShadowMask);
SAMPLER(samplerunity_ShadowMask);

cbuffer limn_PerCameraExtra
{
    float4x4 _PrevViewProjMatrix;
    float4x4 _NonJitteredViewProjMatrix;
    float4 unity_CameraWorldClipPlanes[6]; // left, right, bottom, top, near, far
    float4 _RTHandleScale;
    float4 _ScaleBias; // of what scripts draw over whole targets, and of the targets
    float4 _ScaleBiasRt;
    float4 _ScreenCoordScaleBias; // where scripts render a picture in parts
    float4 _ScreenSizeOverride;
    float4 _DrawObjectPassData; // w: 1 for opaque objects
    float _AlphaToMaskAvailable;
};
#endif
