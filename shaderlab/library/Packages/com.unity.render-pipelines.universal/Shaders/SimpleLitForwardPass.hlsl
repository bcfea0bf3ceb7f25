// Lambert and Blinn-Phong lighting of SimpleLitInput.hlsl.
#pragma once
#ifndef UNIVERSAL_SIMPLE_LIT_PASS_INCLUDED
#define UNIVERSAL_SIMPLE_LIT_PASS_INCLUDED

#include "limn/ForwardPass.hlsl"

Varyings LitPassVertexSimple(Attributes input)
{
    return ForwardPassVertex(input);
}

void LitPassFragmentSimple(Varyings input, out float4 outColor : SV_Target0)
{
    SurfaceData surfaceData;
    InitializeSimpleLitSurfaceData(input.uv, surfaceData);
    LODFadeCrossFade(input.positionCS);

    InputData inputData;
    InitializeInputData(input, surfaceData.normalTS, inputData);
#ifdef _DBUFFER
    ApplyDecalToSurfaceData(input.positionCS, surfaceData, inputData);
#endif
    float4 color = UniversalFragmentBlinnPhong(inputData, surfaceData);
    outColor = limn_Output(color, inputData);
}
#endif
