// Sprites under 2D lights. The author has declared Attributes and Varyings by COMMON_2D_INPUTS and
// COMMON_2D_LIT_OUTPUTS.
#pragma once
#ifndef _LIT_2D_COMMON
#define _LIT_2D_COMMON
#include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/Core2D.hlsl"
#include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/CombinedShapeLightShared.hlsl"

TEXTURE2D(_MainTex);
SAMPLER(sampler_MainTex);
TEXTURE2D(_MaskTex);
SAMPLER(sampler_MaskTex);

Varyings CommonLitVertex(Attributes input)
{
    Varyings result = (Varyings)0;
    result.uv = input.uv;
    result.positionCS = TransformObjectToHClip(input.positionOS);
    float4 screen = ComputeScreenPos(result.positionCS);
    result.lightingUV = (half2)(screen.xy / screen.w);
    return result;
}

half4 CommonLitFragment(Varyings input, half4 color)
{
    half4 lights = SAMPLE_TEXTURE2D(_MaskTex, sampler_MaskTex, input.uv);
    half4 tinted = SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, input.uv) * color;
    InputData2D place;
    InitializeInputData(input.uv, input.lightingUV, place);
    SurfaceData2D surface;
    InitializeSurfaceData(tinted.rgb, tinted.a, lights, surface);
    return CombinedShapeLightShared(surface, place);
}
#endif
