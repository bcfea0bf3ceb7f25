// How the editor draws particles that are chosen or clicked on: in the colour that stands for them,
// where the particle is.
#pragma once
#ifndef UNITY_STANDARD_PARTICLE_EDITOR_INCLUDED
#define UNITY_STANDARD_PARTICLE_EDITOR_INCLUDED
#if defined(_REQUIRE_UV2) && !defined(_FLIPBOOK_BLENDING)
#define _FLIPBOOK_BLENDING 1
#endif
#include "UnityCG.cginc"
#include "UnityShaderVariables.cginc"
#include "UnityStandardConfig.cginc"
#include "UnityStandardUtils.cginc"
#include "UnityStandardParticleInstancing.cginc"
#include "limn/ParticleFlipbook.hlsl"

float _ObjectId;
float _PassValue;
float4 _SelectionID;
float _SelectionAlphaCutoff;

struct VertexOutput
{
    limn_FLIPBOOK_COORDS(0, 1)
    fixed4 color : TEXCOORD2;
};

void vertEditorPass(VertexInput v, out VertexOutput o, out float4 opos : SV_POSITION)
{
    opos = UnityObjectToClipPos(v.vertex);
    limn_TRANSFER_FLIPBOOK(v, o)
    o.color = v.color;
}

void fragSceneClip(VertexOutput i)
{
#ifdef _ALPHATEST_ON
    clip(limn_FLIPBOOK_ALPHA(i) - _Cutoff);
#endif
}
half4 fragSceneHighlightPass(VertexOutput i) : SV_Target
{
    fragSceneClip(i);
    return float4(_ObjectId, _PassValue, 1.0, 1.0);
}
half4 fragScenePickingPass(VertexOutput i) : SV_Target
{
    fragSceneClip(i);
    return _SelectionID;
}
#endif
