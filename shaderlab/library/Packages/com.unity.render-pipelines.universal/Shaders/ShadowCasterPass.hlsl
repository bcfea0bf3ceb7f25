// Depth seen from a light.
#pragma once
#define UNIVERSAL_SHADOW_CASTER_PASS_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/LODCrossFade.hlsl"

// Where the light is: _LightDirection for the sun, _LightPosition for one with a place.
float3 _LightDirection;
float3 _LightPosition;
float3 limn_LightPosition; // relative to limn_Origin

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
    float3 normalWS = TransformObjectToWorldNormal(input.normalOS);
    float3 position = limn_ObjectToRelative(input.positionOS.xyz);
#ifdef _CASTING_PUNCTUAL_LIGHT_SHADOW
    float3 lightDirection = normalize(limn_LightPosition - position);
#else
    float3 lightDirection = _LightDirection;
#endif
    return ApplyShadowClamping(
        limn_RelativeToClip(ApplyShadowBias(position, normalWS, lightDirection)));
}

Varyings ShadowPassVertex(Attributes input)
{
    Varyings output = (Varyings)0;
    output.uv = TRANSFORM_TEX(input.texcoord, _BaseMap);
    output.positionCS = GetShadowPositionHClip(input);
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
