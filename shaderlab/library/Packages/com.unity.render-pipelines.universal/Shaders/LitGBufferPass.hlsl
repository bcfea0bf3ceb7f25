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
    float3 light =
        GlobalIllumination(brdfData, inputData.bakedGI, surfaceData.occlusion,
                           inputData.positionWS, inputData.normalWS, inputData.viewDirectionWS);
    return BRDFDataToGbuffer(brdfData, inputData, surfaceData.smoothness,
                             surfaceData.emission + light, surfaceData.occlusion);
}
#endif
