// The targets of a deferred pass. limn draws forward; the names are there for shaders that have
// such a pass.
#pragma once
#ifndef UNIVERSAL_GBUFFERUTIL_INCLUDED
#define UNIVERSAL_GBUFFERUTIL_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/BRDF.hlsl"

#define kLightingInvalid -1
#define kLightingLit 1
#define kLightingSimpleLit 2

#define kMaterialFlagReceiveShadowsOff 1
#define kMaterialFlagSpecularHighlightsOff 2
#define kMaterialFlagSubtractiveMixedLighting 4
#define kMaterialFlagSpecularSetup 8

struct FragmentOutput
{
    float4 GBuffer0 : SV_Target0; // albedo, material flags
    float4 GBuffer1 : SV_Target1; // reflectivity or specular colour, occlusion
    float4 GBuffer2 : SV_Target2; // normal, smoothness
    float4 GBuffer3 : SV_Target3; // baked and emitted light
};

float PackMaterialFlags(uint materialFlags) { return materialFlags / 255.0; }
uint UnpackMaterialFlags(float packed) { return (uint)(packed * 255.0 + 0.5); }
float3 PackNormal(float3 normal) { return normal; }
float3 UnpackNormal(float3 packed) { return packed; }

FragmentOutput SurfaceDataToGbuffer(SurfaceData surfaceData, InputData inputData,
                                    float3 globalIllumination, int lightingMode)
{
    FragmentOutput output;
    output.GBuffer0 = float4(surfaceData.albedo, PackMaterialFlags(0u));
    output.GBuffer1 = float4(surfaceData.specular, surfaceData.occlusion);
    output.GBuffer2 = float4(PackNormal(inputData.normalWS), surfaceData.smoothness);
    output.GBuffer3 = float4(globalIllumination, 1.0);
    return output;
}
FragmentOutput BRDFDataToGbuffer(BRDFData brdfData, InputData inputData, float smoothness,
                                 float3 globalIllumination, float occlusion = 1.0)
{
    FragmentOutput output;
#ifdef _SPECULAR_SETUP
    output.GBuffer0 = float4(brdfData.albedo, PackMaterialFlags(kMaterialFlagSpecularSetup));
    output.GBuffer1 = float4(brdfData.specular, occlusion);
#else
    output.GBuffer0 = float4(brdfData.albedo, PackMaterialFlags(0u));
    output.GBuffer1 = float4(brdfData.reflectivity, 0.0, 0.0, occlusion);
#endif
    output.GBuffer2 = float4(PackNormal(inputData.normalWS), smoothness);
    output.GBuffer3 = float4(globalIllumination, 1.0);
    return output;
}
#endif
