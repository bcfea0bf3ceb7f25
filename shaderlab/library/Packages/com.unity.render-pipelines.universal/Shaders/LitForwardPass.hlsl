// Physically based lighting of LitInput.hlsl.
#pragma once
#ifndef UNIVERSAL_FORWARD_LIT_PASS_INCLUDED
#define UNIVERSAL_FORWARD_LIT_PASS_INCLUDED

#if defined(_PARALLAXMAP)
#define REQUIRES_TANGENT_SPACE_VIEW_DIR_INTERPOLATOR
#endif

#include "limn/ForwardPass.hlsl"

Varyings LitPassVertex(Attributes input)
{
    return ForwardPassVertex(input);
}

void LitPassFragment(Varyings input, out float4 outColor : SV_Target0)
{
#ifdef _PARALLAXMAP
    ApplyPerPixelDisplacement(input.viewDirTS, input.uv);
#endif
    SurfaceData surfaceData;
    InitializeStandardLitSurfaceData(input.uv, surfaceData);
    LODFadeCrossFade(input.positionCS);

    InputData inputData;
    InitializeInputData(input, surfaceData.normalTS, inputData);
#ifdef _DBUFFER
    ApplyDecalToSurfaceData(input.positionCS, surfaceData, inputData);
#endif
    float4 color = UniversalFragmentPBR(inputData, surfaceData);
    outColor = limn_Output(color, inputData);
}
#endif
