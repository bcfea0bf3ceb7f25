// Ambient light alone.
#pragma once
#ifndef UNIVERSAL_BAKEDLIT_FORWARD_PASS_INCLUDED
#define UNIVERSAL_BAKEDLIT_FORWARD_PASS_INCLUDED

#include "limn/ForwardPass.hlsl"

Varyings BakedLitForwardPassVertex(Attributes input)
{
    return ForwardPassVertex(input);
}

void InitializeBakedLitSurfaceData(float2 uv, out SurfaceData outSurfaceData)
{
    float4 texel = SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, uv);
    outSurfaceData = (SurfaceData)0;
    outSurfaceData.alpha = texel.a * _BaseColor.a;
    AlphaDiscard(outSurfaceData.alpha, _Cutoff);
    outSurfaceData.albedo = AlphaModulate(texel.rgb * _BaseColor.rgb, outSurfaceData.alpha);
    outSurfaceData.normalTS = SampleNormal(uv, TEXTURE2D_ARGS(_BumpMap, sampler_BumpMap));
    outSurfaceData.occlusion = 1.0;
}

void BakedLitForwardPassFragment(Varyings input, out float4 outColor : SV_Target0)
{
    SurfaceData surfaceData;
    InitializeBakedLitSurfaceData(input.uv, surfaceData);
    LODFadeCrossFade(input.positionCS);

    InputData inputData;
    InitializeInputData(input, surfaceData.normalTS, inputData);
#ifdef _DBUFFER
    ApplyDecalToSurfaceData(input.positionCS, surfaceData, inputData);
#endif
    float4 color = UniversalFragmentBakedLit(inputData, surfaceData);
    outColor = limn_Output(color, inputData);
}
#endif
