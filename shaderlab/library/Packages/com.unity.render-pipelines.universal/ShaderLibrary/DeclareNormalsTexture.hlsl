#pragma once
#ifndef UNITY_DECLARE_NORMALS_TEXTURE_INCLUDED
#define UNITY_DECLARE_NORMALS_TEXTURE_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

TEXTURE2D_X_FLOAT(_CameraNormalsTexture);
SAMPLER(sampler_CameraNormalsTexture);
float4 _CameraNormalsTexture_TexelSize;

// World space, signed; zero where nothing was drawn.
float3 SampleSceneNormals(float2 uv, SAMPLER(samplerParam))
{
    return SAMPLE_TEXTURE2D_X(_CameraNormalsTexture, samplerParam, uv).xyz;
}
float3 SampleSceneNormals(float2 uv)
{
    return SAMPLE_TEXTURE2D_X(_CameraNormalsTexture, sampler_CameraNormalsTexture, uv).xyz;
}
float3 LoadSceneNormals(uint2 uv) { return LOAD_TEXTURE2D_X(_CameraNormalsTexture, uv).xyz; }
#endif
