// Per-draw values come from one buffer with an element per object, so that draws of equal mesh and
// state can run as one. The names that shaders use are macros over it. The layout is
// limn::PerDrawData.
#pragma once

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

// Set by the generated entry function: the instance's element in the vertex stage, that of
// limn_FirstInstance in the others.
static uint limn_DrawIndex;

#define unity_ObjectToWorld (limn_PerDraw[limn_DrawIndex].objectToWorld)
#define unity_WorldToObject (limn_PerDraw[limn_DrawIndex].worldToObject)
#define unity_WorldTransformParams (limn_PerDraw[limn_DrawIndex].worldTransformParams)
#define unity_RenderingLayer (asfloat(limn_PerDraw[limn_DrawIndex].renderingLayer))

// No cross-fading between levels of detail.
#define unity_LODFade float4(1, 0, 0, 0)
