#pragma once
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

TEXTURE2D_X(_CameraRenderingLayersTexture);
SAMPLER(sampler_CameraRenderingLayersTexture);

uint SampleSceneRenderingLayer(float2 uv)
{
    float4 texel = SAMPLE_TEXTURE2D_X_LOD(_CameraRenderingLayersTexture,
                                          sampler_CameraRenderingLayersTexture, uv, 0);
    return DecodeMeshRenderingLayer(texel.r);
}
uint LoadSceneRenderingLayer(uint2 uv)
{
    return DecodeMeshRenderingLayer(LOAD_TEXTURE2D_X(_CameraRenderingLayersTexture, uv).r);
}
