// Textures and samplers as one value, with what a shader graph asks of them. They convert by name:
// UnityBuildTexture2DStruct takes a texture whose sampler, _TexelSize and _ST bear its name.
#pragma once

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

struct UnitySamplerState
{
    SamplerState samplerstate;
};
#define UnityBuildSamplerStateStruct(n) limn_UnitySamplerState(n)
UnitySamplerState limn_UnitySamplerState(SamplerState samplerstate)
{
    UnitySamplerState result;
    result.samplerstate = samplerstate;
    return result;
}

// The methods that sample `tex`, each with a sampler of either kind.
#define limn_SAMPLING(Place) \
    float4 Sample(SamplerState s, Place at) { return tex.Sample(s, at); } \
    float4 Sample(UnitySamplerState s, Place at) { return tex.Sample(s.samplerstate, at); } \
    float4 SampleLevel(SamplerState s, Place at, float lod) { return tex.SampleLevel(s, at, lod); } \
    float4 SampleLevel(UnitySamplerState s, Place at, float lod) \
    { \
        return tex.SampleLevel(s.samplerstate, at, lod); \
    } \
    float4 SampleBias(SamplerState s, Place at, float bias) { return tex.SampleBias(s, at, bias); } \
    float4 SampleBias(UnitySamplerState s, Place at, float bias) \
    { \
        return tex.SampleBias(s.samplerstate, at, bias); \
    }
#define limn_SAMPLING_BY_SLOPES(Place) \
    float4 SampleGrad(SamplerState s, Place at, float2 dpdx, float2 dpdy) \
    { \
        return tex.SampleGrad(s, at, dpdx, dpdy); \
    } \
    float4 SampleGrad(UnitySamplerState s, Place at, float2 dpdx, float2 dpdy) \
    { \
        return tex.SampleGrad(s.samplerstate, at, dpdx, dpdy); \
    }

struct UnityTexture2D
{
    Texture2D tex;
    SamplerState samplerstate;
    float4 texelSize;
    float4 scaleTranslate;

    limn_SAMPLING(float2)
    limn_SAMPLING_BY_SLOPES(float2)
    float4 Load(int3 pixel) { return tex.Load(pixel); }
    float2 GetTransformedUV(float2 uv) { return uv * scaleTranslate.xy + scaleTranslate.zw; }
};
#define UnityBuildTexture2DStruct(n) limn_UnityTexture2D(n, sampler##n, n##_TexelSize, n##_ST)
#define UnityBuildTexture2DStructNoScale(n) \
    limn_UnityTexture2D(n, sampler##n, n##_TexelSize, float4(1, 1, 0, 0))
UnityTexture2D limn_UnityTexture2D(Texture2D tex, SamplerState samplerstate, float4 texelSize,
                                   float4 scaleTranslate)
{
    UnityTexture2D made;
    made.scaleTranslate = scaleTranslate;
    made.texelSize = texelSize;
    made.samplerstate = samplerstate;
    made.tex = tex;
    return made;
}

// The function that makes the structure of a texture and its sampler.
#define limn_MAKING(Kind) \
    Unity##Kind limn_Unity##Kind(Kind tex, SamplerState samplerstate) \
    { \
        Unity##Kind made; \
        made.samplerstate = samplerstate; \
        made.tex = tex; \
        return made; \
    }

// The z of a place is the element.
struct UnityTexture2DArray
{
    Texture2DArray tex;
    SamplerState samplerstate;

    limn_SAMPLING(float3)
    limn_SAMPLING_BY_SLOPES(float3)
    float4 Load(int4 pixel) { return tex.Load(pixel); }
};
#define UnityBuildTexture2DArrayStruct(n) limn_UnityTexture2DArray(n, sampler##n)
limn_MAKING(Texture2DArray)

struct UnityTextureCube
{
    TextureCube tex;
    SamplerState samplerstate;

    limn_SAMPLING(float3)
};
#define UnityBuildTextureCubeStruct(n) limn_UnityTextureCube(n, sampler##n)
limn_MAKING(TextureCube)

struct UnityTexture3D
{
    Texture3D tex;
    SamplerState samplerstate;

    limn_SAMPLING(float3)
    float4 Load(int4 pixel) { return tex.Load(pixel); }
};
#define UnityBuildTexture3DStruct(n) limn_UnityTexture3D(n, sampler##n)
limn_MAKING(Texture3D)
