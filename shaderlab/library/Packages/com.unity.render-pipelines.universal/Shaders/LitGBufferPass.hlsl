// The deferred pass of LitInput.hlsl.
#pragma once
#ifndef UNIVERSAL_LIT_GBUFFER_PASS_INCLUDED
#define UNIVERSAL_LIT_GBUFFER_PASS_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityGBuffer.hlsl"
#include "Packages/com.unity.render-pipelines.universal/Shaders/LitForwardPass.hlsl"

Varyings LitGBufferPassVertex(Attributes input) { return LitPassVertex(input); }

FragmentOutput LitGBufferPassFragment(Varyings input)
{
#ifdef _PARALLAXMAP
    ApplyPerPixelDisplacement(input.viewDirTS, input.uv);
#endif
    SurfaceData surfaceData;
    InitializeStandardLitSurfaceData(input.uv, surfaceData);
    LODFadeCrossFade(input.positionCS);
    InputData inputData;
    InitializeInputData(input, surfaceData.normalTS, inputData);

    BRDFData brdfData;
    InitializeBRDFData(surfaceData, brdfData);
    float open = surfaceData.occlusion;
    float3 around = GlobalIllumination(brdfData, inputData.bakedGI, open, inputData.positionWS,
                                       inputData.normalWS, inputData.viewDirectionWS);
    float3 glow = around + surfaceData.emission; // no lamp shines yet
    return BRDFDataToGbuffer(brdfData, inputData, surfaceData.smoothness, glow, open);
}
#endif
