// Unlit: texture times colour, and fog.
#pragma once
#ifndef URP_UNLIT_FORWARD_PASS_INCLUDED
#define URP_UNLIT_FORWARD_PASS_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Unlit.hlsl"

struct Attributes
{
    float4 positionOS : POSITION;
    float2 uv : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float2 uv : TEXCOORD0;
    float fogCoord : TEXCOORD1;
    float4 positionCS : SV_POSITION;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

Varyings UnlitPassVertex(Attributes input)
{
    Varyings output = (Varyings)0;
    output.positionCS = TransformObjectToHClip(input.positionOS.xyz);
    output.uv = TRANSFORM_TEX(input.uv, _BaseMap);
    output.fogCoord = ComputeFogFactor(output.positionCS.z);
    return output;
}

void UnlitPassFragment(Varyings input, out float4 outColor : SV_Target0)
{
    float4 texel = SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, input.uv);
    float alpha = texel.a * _BaseColor.a;
    AlphaDiscard(alpha, _Cutoff);
    float3 color = AlphaModulate(texel.rgb * _BaseColor.rgb, alpha);

    InputData inputData = (InputData)0;
    inputData.positionCS = input.positionCS;
    inputData.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(input.positionCS);
    float4 result = UniversalFragmentUnlit(inputData, color, alpha);
    outColor = float4(MixFog(result.rgb, input.fogCoord),
                      OutputAlpha(result.a, IsSurfaceTypeTransparent(_Surface)));
}
#endif
