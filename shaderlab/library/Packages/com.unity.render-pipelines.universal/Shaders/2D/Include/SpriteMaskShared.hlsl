// Sprites that mark where others show.
#pragma once
#define SPRITE_MASK_SHARED

half _Cutoff;
TEXTURE2D(_MainTex);
SAMPLER(sampler_MainTex);

struct Attributes
{
    float4 positionOS : POSITION;
    half2 texcoord : TEXCOORD0;
};
struct Varyings
{
    float4 positionCS : SV_POSITION;
    half2 uv : TEXCOORD0;
};

Varyings MaskRenderingVertex(Attributes input)
{
    Varyings corner;
    corner.uv = input.texcoord;
    corner.positionCS = TransformObjectToHClip(input.positionOS.xyz);
    return corner;
}
half4 MaskRenderingFragment(Varyings input) : SV_Target
{
    clip(SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, input.uv).a - _Cutoff);
    return half4(1, 1, 1, 0.2);
}
