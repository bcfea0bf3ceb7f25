// How much ambient light reaches a point, by a texture of the screen.
#pragma once
#ifndef AMBIENT_OCCLUSION_INCLUDED
#define AMBIENT_OCCLUSION_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceData.hlsl"

TEXTURE2D_X(_ScreenSpaceOcclusionTexture);
SAMPLER(sampler_ScreenSpaceOcclusionTexture);

struct AmbientOcclusionFactor
{
    float indirectAmbientOcclusion;
    float directAmbientOcclusion;
};

float SampleAmbientOcclusion(float2 normalizedScreenSpaceUV)
{
    return SAMPLE_TEXTURE2D_X(_ScreenSpaceOcclusionTexture, sampler_ScreenSpaceOcclusionTexture,
                              normalizedScreenSpaceUV)
        .x;
}

AmbientOcclusionFactor GetScreenSpaceAmbientOcclusion(float2 normalizedScreenSpaceUV)
{
    AmbientOcclusionFactor factor;
#if defined(_SCREEN_SPACE_OCCLUSION) && !defined(_SURFACE_TYPE_TRANSPARENT)
    factor.indirectAmbientOcclusion = SampleAmbientOcclusion(normalizedScreenSpaceUV);
    factor.directAmbientOcclusion =
        lerp(1.0, factor.indirectAmbientOcclusion, _AmbientOcclusionParam.w);
#else
    factor.indirectAmbientOcclusion = 1.0;
    factor.directAmbientOcclusion = 1.0;
#endif
    return factor;
}

AmbientOcclusionFactor CreateAmbientOcclusionFactor(float2 normalizedScreenSpaceUV, float occlusion)
{
    AmbientOcclusionFactor factor = GetScreenSpaceAmbientOcclusion(normalizedScreenSpaceUV);
    factor.indirectAmbientOcclusion = min(factor.indirectAmbientOcclusion, occlusion);
    return factor;
}
AmbientOcclusionFactor CreateAmbientOcclusionFactor(InputData inputData, SurfaceData surfaceData)
{
    return CreateAmbientOcclusionFactor(inputData.normalizedScreenSpaceUV, surfaceData.occlusion);
}
#endif
