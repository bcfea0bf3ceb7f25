// Meshes that the alpha of a texture cuts out, with the names that URP's materials have.
#pragma once

TEXTURE2D(_BaseMap);
SAMPLER(sampler_BaseMap);
float4 _BaseMap_ST;
half4 _BaseColor;
half _Cutoff;

struct CutoutVaryings
{
    float4 position : SV_POSITION;
    float2 uv : TEXCOORD0;
};

CutoutVaryings CutoutVertex(float4 positionOS : POSITION, float2 uv : TEXCOORD0)
{
    CutoutVaryings output;
    output.position = TransformObjectToHClip(positionOS.xyz);
    output.uv = TRANSFORM_TEX(uv, _BaseMap);
    return output;
}

// The part of the pixel that is left, smooth along the cut.
half CutoutPart(float2 uv)
{
    half alpha = SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, uv).a * _BaseColor.a;
    return saturate((alpha - _Cutoff) / max(fwidth(alpha), 1e-4) + 0.5);
}
