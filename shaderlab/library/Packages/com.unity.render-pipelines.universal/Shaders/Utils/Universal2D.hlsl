// A texture times a colour, for the pass that draws sprites.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

struct Attributes
{
    float4 positionOS : POSITION;
    float2 uv : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float2 uv : TEXCOORD0;
    float4 vertex : SV_POSITION;
};

Varyings vert(Attributes input)
{
    Varyings output = (Varyings)0;
    output.vertex = TransformObjectToHClip(input.positionOS.xyz);
    output.uv = TRANSFORM_TEX(input.uv, _BaseMap);
    return output;
}

float4 frag(Varyings input) : SV_Target
{
    float4 texel = SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, input.uv);
    float alpha = texel.a * _BaseColor.a;
    AlphaDiscard(alpha, _Cutoff);
    return float4(AlphaModulate(texel.rgb * _BaseColor.rgb, alpha), alpha);
}
