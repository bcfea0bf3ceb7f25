#pragma once
#ifndef UNIVERSAL_GBUFFEROUTPUT_INCLUDED
#define UNIVERSAL_GBUFFEROUTPUT_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/GBufferCommon.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"

struct GBufferFragOutput
{
    half4 gBuffer0 : SV_Target0; // as in FragmentOutput
    half4 gBuffer1 : SV_Target1;
    half4 gBuffer2 : SV_Target2;
    half4 color : SV_Target3;
};

GBufferFragOutput limn_GBufferFragOutput(FragmentOutput stored)
{
    GBufferFragOutput output;
    output.gBuffer0 = stored.GBuffer0;
    output.gBuffer1 = stored.GBuffer1;
    output.gBuffer2 = stored.GBuffer2;
    output.color = stored.GBuffer3;
    return output;
}
GBufferFragOutput PackGBuffersSurfaceData(SurfaceData surfaceData, InputData inputData,
                                          half3 globalIllumination)
{
    return limn_GBufferFragOutput(
        SurfaceDataToGbuffer(surfaceData, inputData, globalIllumination, kLightingSimpleLit));
}
GBufferFragOutput PackGBuffersBRDFData(BRDFData brdfData, InputData inputData, half smoothness,
                                       half3 globalIllumination, half occlusion = 1.0)
{
    return limn_GBufferFragOutput(
        BRDFDataToGbuffer(brdfData, inputData, smoothness, globalIllumination, occlusion));
}
#endif
