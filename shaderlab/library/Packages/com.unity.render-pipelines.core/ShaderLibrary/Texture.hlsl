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

struct UnityTexture2D
{
    Texture2D tex;
    SamplerState samplerstate;
    float4 texelSize;
    float4 scaleTranslate;

    float4 Sample(UnitySamplerState s, float2 uv) { return tex.Sample(s.samplerstate, uv); }
    float4 Sample(SamplerState s, float2 uv) { return tex.Sample(s, uv); }
    float4 SampleLevel(UnitySamplerState s, float2 uv, float lod)
    {
        return tex.SampleLevel(s.samplerstate, uv, lod);
    }
    float4 SampleLevel(SamplerState s, float2 uv, float lod) { return tex.SampleLevel(s, uv, lod); }
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
