#pragma once
#include "limn/Platform.hlsl"

#define fixed float
#define fixed2 float2
#define fixed3 float3
#define fixed4 float4
#define fixed2x2 float2x2
#define fixed3x3 float3x3
#define fixed4x4 float4x4
#define sampler2D_half sampler2D
#define sampler2D_float sampler2D
#define samplerCUBE_half samplerCUBE
#define samplerCUBE_float samplerCUBE

#define UNITY_INITIALIZE_OUTPUT(type, name) name = (type)0
#define UNITY_DECLARE_TEX2D(tex) Texture2D tex; SamplerState sampler##tex
#define UNITY_DECLARE_TEX2D_NOSAMPLER(tex) Texture2D tex
#define UNITY_SAMPLE_TEX2D(tex, uv) tex.Sample(sampler##tex, uv)
#define UNITY_SAMPLE_TEX2D_LOD(tex, uv, lod) tex.SampleLevel(sampler##tex, uv, lod)
#define UNITY_SAMPLE_TEX2D_SAMPLER(tex, smp, uv) tex.Sample(sampler##smp, uv)
#define UNITY_DECLARE_TEXCUBE(tex) TextureCube tex; SamplerState sampler##tex
#define UNITY_SAMPLE_TEXCUBE(tex, direction) tex.Sample(sampler##tex, direction)
#define UNITY_SAMPLE_TEXCUBE_LOD(tex, direction, lod) tex.SampleLevel(sampler##tex, direction, lod)
#define UNITY_DECLARE_DEPTH_TEXTURE(tex) sampler2D tex
#define UNITY_DECLARE_SCREENSPACE_TEXTURE(tex) sampler2D tex
#define UNITY_SAMPLE_SCREENSPACE_TEXTURE(tex, uv) tex2D(tex, uv)
#define SAMPLE_DEPTH_TEXTURE(tex, uv) tex2D(tex, uv).r
#define SAMPLE_DEPTH_TEXTURE_PROJ(tex, uv) tex2Dproj(tex, uv).r
#define UNITY_PROJ_COORD(coord) coord
#define UnityStereoTransformScreenSpaceTex(uv) uv
#define UNITY_OPAQUE_ALPHA(alpha) alpha = 1.0
