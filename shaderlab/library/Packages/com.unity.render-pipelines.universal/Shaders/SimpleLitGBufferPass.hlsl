// The deferred pass of SimpleLitInput.hlsl.
#pragma once
#ifndef UNIVERSAL_SIMPLE_LIT_GBUFFER_PASS_INCLUDED
#define UNIVERSAL_SIMPLE_LIT_GBUFFER_PASS_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityGBuffer.hlsl"

// Unity gives the forward function this name too.
#define LitPassFragmentSimple limn_ForwardFragmentSimple
#include "Packages/com.unity.render-pipelines.universal/Shaders/SimpleLitForwardPass.hlsl"
#undef LitPassFragmentSimple

FragmentOutput LitPassFragmentSimple(Varyings input)
{
    SurfaceData surfaceData;
    InitializeSimpleLitSurfaceData(input.uv, surfaceData);
    LODFadeCrossFade(input.positionCS);
    InputData inputData;
    InitializeInputData(input, surfaceData.normalTS, inputData);
    return SurfaceDataToGbuffer(surfaceData, inputData,
                                surfaceData.emission + inputData.bakedGI * surfaceData.albedo,
                                kLightingSimpleLit);
}
#endif
