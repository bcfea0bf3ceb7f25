#pragma once
#ifndef UNIVERSAL_PIPELINE_CORE_INCLUDED
#define UNIVERSAL_PIPELINE_CORE_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Packing.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/GlobalSamplers.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Version.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Input.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/TextureXR.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/ShaderVariablesFunctions.hlsl"

// With this pipeline, sampling by derivatives adds the bias that upscaling asks for.
#undef SAMPLE_TEXTURE2D
#undef SAMPLE_TEXTURE2D_BIAS
#undef SAMPLE_TEXTURE2D_ARRAY
#undef SAMPLE_TEXTURE2D_ARRAY_BIAS
#undef SAMPLE_TEXTURECUBE
#undef SAMPLE_TEXTURECUBE_BIAS
#define SAMPLE_TEXTURE2D(name, smp, uv) name.SampleBias(smp, uv, _GlobalMipBias.x)
#define SAMPLE_TEXTURE2D_BIAS(name, smp, uv, bias) \
    name.SampleBias(smp, uv, (bias) + _GlobalMipBias.x)
#define SAMPLE_TEXTURE2D_ARRAY(name, smp, uv, index) \
    name.SampleBias(smp, float3(uv, index), _GlobalMipBias.x)
#define SAMPLE_TEXTURE2D_ARRAY_BIAS(name, smp, uv, index, bias) \
    name.SampleBias(smp, float3(uv, index), (bias) + _GlobalMipBias.x)
#define SAMPLE_TEXTURECUBE(name, smp, direction) name.SampleBias(smp, direction, _GlobalMipBias.x)
#define SAMPLE_TEXTURECUBE_BIAS(name, smp, direction, bias) \
    name.SampleBias(smp, direction, (bias) + _GlobalMipBias.x)
#endif
