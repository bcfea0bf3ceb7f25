// Per-draw values come from one buffer with an element per object, so that draws of equal mesh and
// state can run as one. The names that shaders use are macros over it. The layout is
// limn::PerDrawData.
#pragma once
#include "limn/Platform.hlsl"

struct limn_PerDrawData
{
    float4x4 objectToWorld;
    float4x4 worldToObject;
    float4 worldTransformParams;
    uint4 renderingLayer;
};

StructuredBuffer<limn_PerDrawData> limn_PerDraw;
// The element of each instance.
StructuredBuffer<uint> limn_Instances;

#ifdef PROCEDURAL_INSTANCING_ON
// However many instances there are, they have one element.
#define limn_DrawIndex (limn_Instances[limn_FirstInstance])
#else
// Set by the generated entry function: the instance's element in the vertex stage, that of
// limn_FirstInstance in the others.
static uint limn_DrawIndex;
#endif

#ifdef UNITY_INSTANCING_PROCEDURAL_FUNC
static float4x4 unity_ObjectToWorld;
static float4x4 unity_WorldToObject;

void UNITY_INSTANCING_PROCEDURAL_FUNC();

void limn_SetupInstance(uint instanceID)
{
    unity_InstanceID = instanceID;
    unity_ObjectToWorld = limn_PerDraw[limn_DrawIndex].objectToWorld;
    unity_WorldToObject = limn_PerDraw[limn_DrawIndex].worldToObject;
    UNITY_INSTANCING_PROCEDURAL_FUNC();
}
#else
#define unity_ObjectToWorld (limn_PerDraw[limn_DrawIndex].objectToWorld)
#define unity_WorldToObject (limn_PerDraw[limn_DrawIndex].worldToObject)
#endif
#define unity_WorldTransformParams (limn_PerDraw[limn_DrawIndex].worldTransformParams)
#define unity_RenderingLayer (asfloat(limn_PerDraw[limn_DrawIndex].renderingLayer))

// No object is between two levels of detail: x is how much of it shows where levels cross-fade, but
// how far it is on its way to the next one where they blend.
#if defined(LOD_FADE_PERCENTAGE) && !defined(LOD_FADE_CROSSFADE)
#define unity_LODFade float4(0, 0, 0, 0)
#else
#define unity_LODFade float4(1, 0, 0, 0)
#endif
