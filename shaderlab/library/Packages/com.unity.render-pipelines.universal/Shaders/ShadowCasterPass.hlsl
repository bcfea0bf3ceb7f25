// Depth seen from a light.
#pragma once
#ifndef UNIVERSAL_SHADOW_CASTER_PASS_INCLUDED
#define UNIVERSAL_SHADOW_CASTER_PASS_INCLUDED

#include "limn/ShadowCaster.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/LODCrossFade.hlsl"

struct Attributes
{
    float4 positionOS : POSITION;
    float3 normalOS : NORMAL;
    float2 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float2 uv : TEXCOORD0;
    float4 positionCS : SV_POSITION;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

float4 GetShadowPositionHClip(Attributes input)
{
    return limn_ShadowCasterClip(input.positionOS.xyz, input.normalOS);
}

Varyings ShadowPassVertex(Attributes input)
{
    Varyings output = (Varyings)0;
    output.positionCS = GetShadowPositionHClip(input);
#ifdef _ALPHATEST_ON
    output.uv = TRANSFORM_TEX(input.texcoord, _BaseMap);
#endif
    return output;
}

float4 ShadowPassFragment(Varyings input) : SV_TARGET
{
#ifdef _ALPHATEST_ON
    Alpha(SampleAlbedoAlpha(input.uv, TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap)).a, _BaseColor,
          _Cutoff);
#endif
    LODFadeCrossFade(input.positionCS);
    return 0;
}
#endif
