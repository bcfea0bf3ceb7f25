// The pass that draws how far each point has moved over the screen since the last frame. It brings
// its pragmas along: shaders have it behind #include_with_pragmas and nothing else.
#pragma once
#ifndef UNIVERSAL_OBJECT_MOTION_VECTORS_INCLUDED
#define UNIVERSAL_OBJECT_MOTION_VECTORS_INCLUDED

#pragma target 3.5
#pragma vertex vert
#pragma fragment frag
#pragma multi_compile_instancing

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/LODCrossFade.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/MotionVectorsCommon.hlsl"

struct Attributes
{
    float4 position : POSITION;
    float2 uv : TEXCOORD0;
    float3 positionOld : TEXCOORD4;
    float3 alembicMotionVector : TEXCOORD5;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 positionCS : SV_POSITION;
    float4 positionCSNoJitter : POSITION_CS_NO_JITTER;
    float4 previousPositionCSNoJitter : PREV_POSITION_CS_NO_JITTER;
    float2 uv : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

Varyings vert(Attributes input)
{
    Varyings output = (Varyings)0;
    float3 before = unity_MotionVectorsParams.x == 1.0 ? input.positionOld : input.position.xyz;
#ifdef _ADD_PRECOMPUTED_VELOCITY
    before -= input.alembicMotionVector;
#endif
    output.previousPositionCSNoJitter =
        mul(_PrevViewProjMatrix, mul(UNITY_PREV_MATRIX_M, float4(before, 1.0)));
    output.positionCSNoJitter =
        mul(_NonJitteredViewProjMatrix, mul(UNITY_MATRIX_M, float4(input.position.xyz, 1.0)));
#if defined(APPLICATION_SPACE_WARP_MOTION) || defined(APLICATION_SPACE_WARP_MOTION)
    output.positionCS = output.positionCSNoJitter;
#else
    output.positionCS = TransformObjectToHClip(input.position.xyz);
#endif
#ifdef _ALPHATEST_ON
    output.uv = TRANSFORM_TEX(input.uv, _BaseMap);
#endif
    return output;
}

float4 frag(Varyings input) : SV_Target
{
#ifdef _ALPHATEST_ON
    Alpha(SampleAlbedoAlpha(input.uv, TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap)).a, _BaseColor,
          _Cutoff);
#endif
    LODFadeCrossFade(input.positionCS);
#if defined(APPLICATION_SPACE_WARP_MOTION) || defined(APLICATION_SPACE_WARP_MOTION)
    return float4(CalcAswNdcMotionVectorFromCsPositions(input.positionCSNoJitter,
                                                        input.previousPositionCSNoJitter), 1.0);
#else
    return float4(CalcNdcMotionVectorFromCsPositions(input.positionCSNoJitter,
                                                     input.previousPositionCSNoJitter), 0.0, 0.0);
#endif
}
#endif
