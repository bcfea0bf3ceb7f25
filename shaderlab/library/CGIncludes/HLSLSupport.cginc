// Spellings of the old shading language, and the texture macros of the built-in pipeline. A texture
// t that is declared with its sampler has the sampler samplert.
#pragma once
#ifndef HLSL_SUPPORT_INCLUDED
#define HLSL_SUPPORT_INCLUDED
#include "limn/OldSampling.hlsl"
#include "limn/Platform.hlsl"

#define fixed float
#define fixed1 float1
#define fixed2 float2
#define fixed3 float3
#define fixed4 float4
#define fixed2x2 float2x2
#define fixed3x3 float3x3
#define fixed3x4 float3x4
#define fixed4x3 float4x3
#define fixed4x4 float4x4

// Opposites of keywords, by which older shaders ask.
#ifndef LIGHTMAP_ON
#define LIGHTMAP_OFF 1
#endif
#ifndef DIRLIGHTMAP_COMBINED
#define DIRLIGHTMAP_OFF 1
#endif
#ifndef DYNAMICLIGHTMAP_ON
#define DYNAMICLIGHTMAP_OFF 1
#endif

#define UNITY_CAN_COMPILE_TESSELLATION 1
#define UNITY_domain domain
#define UNITY_partitioning partitioning
#define UNITY_outputtopology outputtopology
#define UNITY_patchconstantfunc patchconstantfunc
#define UNITY_outputcontrolpoints outputcontrolpoints
#define UNITY_SEPARATE_TEXTURE_SAMPLER 1
#define UNITY_ATTEN_CHANNEL r
#define UNITY_POSITION(pos) float4 pos : SV_POSITION
#define UNITY_VPOS_TYPE float4
#define UNITY_FIXED_IS_HALF 0
#define UNITY_INITIALIZE_OUTPUT(type, name) name = (type)0;
#define UNITY_PROJ_COORD(coord) coord
#define UNITY_SAMPLE_DEPTH(value) ((value).r)
#define UNITY_OPAQUE_ALPHA(alpha) alpha = 1.0
#define CBUFFER_START_WITH_BINDING(name, set, index) CBUFFER_START(name)
#define GLOBAL_CBUFFER_START(name) CBUFFER_START(name)
#define GLOBAL_CBUFFER_END CBUFFER_END

// 2D
#define UNITY_DECLARE_TEX2D(tex) Texture2D tex; SamplerState sampler##tex
#define UNITY_DECLARE_TEX2D_FLOAT(tex) UNITY_DECLARE_TEX2D(tex)
#define UNITY_DECLARE_TEX2D_HALF(tex) UNITY_DECLARE_TEX2D(tex)
#define UNITY_DECLARE_TEX2D_NOSAMPLER(tex) Texture2D tex
#define UNITY_DECLARE_TEX2D_NOSAMPLER_FLOAT(tex) Texture2D tex
#define UNITY_DECLARE_TEX2D_NOSAMPLER_HALF(tex) Texture2D tex
#define UNITY_DECLARE_TEX2D_NOSAMPLER_INT(tex) Texture2D<int4> tex
#define UNITY_DECLARE_TEX2D_NOSAMPLER_UINT(tex) Texture2D<uint4> tex
#define UNITY_SAMPLE_1CHANNEL(map, uv) tex2D((map), (uv)).r
#define UNITY_SAMPLE_TEX2D(tex, uv) tex.Sample(sampler##tex, uv)
#define UNITY_SAMPLE_TEX2D_LOD(tex, uv, lod) tex.SampleLevel(sampler##tex, uv, lod)
#define UNITY_SAMPLE_TEX2D_SAMPLER(tex, smp, uv) tex.Sample(sampler##smp, uv)
#define UNITY_SAMPLE_TEX2D_SAMPLER_LOD(tex, smp, uv, lod) tex.SampleLevel(sampler##smp, uv, lod)
#define UNITY_ARGS_TEX2D(tex) Texture2D tex, SamplerState sampler##tex
#define UNITY_PASS_TEX2D(tex) tex, sampler##tex
#define UNITY_PASS_TEX2D_SAMPLER(tex, smp) tex, sampler##smp

// 2D arrays
#define UNITY_DECLARE_TEX2DARRAY(tex) Texture2DArray tex; SamplerState sampler##tex
#define UNITY_DECLARE_TEX2DARRAY_NOSAMPLER(tex) Texture2DArray tex
#define UNITY_ARGS_TEX2DARRAY(tex) Texture2DArray tex, SamplerState sampler##tex
#define UNITY_PASS_TEX2DARRAY(tex) tex, sampler##tex
#define UNITY_SAMPLE_TEX2DARRAY(tex, uvi) tex.Sample(sampler##tex, uvi)
#define UNITY_SAMPLE_TEX2DARRAY_LOD(tex, uvi, lod) tex.SampleLevel(sampler##tex, uvi, lod)
#define UNITY_SAMPLE_TEX2DARRAY_SAMPLER(tex, smp, uvi) tex.Sample(sampler##smp, uvi)
#define UNITY_SAMPLE_TEX2DARRAY_SAMPLER_LOD(tex, smp, uvi, lod) tex.SampleLevel(sampler##smp, uvi, lod)

// Cubes
#define UNITY_DECLARE_TEXCUBE(tex) TextureCube tex; SamplerState sampler##tex
#define UNITY_DECLARE_TEXCUBE_NOSAMPLER(tex) TextureCube tex
#define UNITY_ARGS_TEXCUBE(tex) TextureCube tex, SamplerState sampler##tex
#define UNITY_PASS_TEXCUBE(tex) tex, sampler##tex
#define UNITY_PASS_TEXCUBE_SAMPLER(tex, smp) tex, sampler##smp
#define UNITY_SAMPLE_TEXCUBE(tex, direction) tex.Sample(sampler##tex, direction)
#define UNITY_SAMPLE_TEXCUBE_LOD(tex, direction, lod) tex.SampleLevel(sampler##tex, direction, lod)
#define UNITY_SAMPLE_TEXCUBE_SAMPLER(tex, smp, direction) tex.Sample(sampler##smp, direction)
#define UNITY_SAMPLE_TEXCUBE_SAMPLER_LOD(tex, smp, direction, lod) \
    tex.SampleLevel(sampler##smp, direction, lod)
#define UNITY_DECLARE_TEXCUBEARRAY(tex) TextureCubeArray tex; SamplerState sampler##tex
#define UNITY_DECLARE_TEXCUBEARRAY_NOSAMPLER(tex) TextureCubeArray tex
#define UNITY_SAMPLE_TEXCUBEARRAY(tex, direction) tex.Sample(sampler##tex, direction)
#define UNITY_SAMPLE_TEXCUBEARRAY_LOD(tex, direction, lod) \
    tex.SampleLevel(sampler##tex, direction, lod)

// 3D
#define UNITY_DECLARE_TEX3D(tex) Texture3D tex; SamplerState sampler##tex
#define UNITY_DECLARE_TEX3D_FLOAT(tex) UNITY_DECLARE_TEX3D(tex)
#define UNITY_DECLARE_TEX3D_HALF(tex) UNITY_DECLARE_TEX3D(tex)
#define UNITY_DECLARE_TEX3D_NOSAMPLER(tex) Texture3D tex
#define UNITY_SAMPLE_TEX3D(tex, uvw) tex.Sample(sampler##tex, uvw)
#define UNITY_SAMPLE_TEX3D_LOD(tex, uvw, lod) tex.SampleLevel(sampler##tex, uvw, lod)
#define UNITY_SAMPLE_TEX3D_SAMPLER(tex, smp, uvw) tex.Sample(sampler##smp, uvw)
#define UNITY_SAMPLE_TEX3D_SAMPLER_LOD(tex, smp, uvw, lod) tex.SampleLevel(sampler##smp, uvw, lod)

// Textures that samples are compared with
#define SHADOWS_NATIVE 1
#define UNITY_DECLARE_SHADOWMAP(tex) Texture2D tex; SamplerComparisonState sampler##tex
#define UNITY_SAMPLE_SHADOW(tex, uvz) tex.SampleCmpLevelZero(sampler##tex, (uvz).xy, (uvz).z)
#define UNITY_SAMPLE_SHADOW_PROJ(tex, uvzw) \
    tex.SampleCmpLevelZero(sampler##tex, (uvzw).xy / (uvzw).w, (uvzw).z / (uvzw).w)

// Depth and what else covers the screen: with one eye, plain 2D textures.
#define UNITY_DECLARE_DEPTH_TEXTURE(tex) sampler2D tex
#define UNITY_DECLARE_DEPTH_TEXTURE_MS(tex) Texture2DMS<float> tex
#define SAMPLE_RAW_DEPTH_TEXTURE(tex, uv) tex2D(tex, uv)
#define SAMPLE_RAW_DEPTH_TEXTURE_PROJ(tex, uv) tex2Dproj(tex, uv)
#define SAMPLE_RAW_DEPTH_TEXTURE_LOD(tex, uv) tex2Dlod(tex, uv)
#define SAMPLE_DEPTH_TEXTURE(tex, uv) (tex2D(tex, uv).r)
#define SAMPLE_DEPTH_TEXTURE_PROJ(tex, uv) (tex2Dproj(tex, uv).r)
#define SAMPLE_DEPTH_TEXTURE_LOD(tex, uv) (tex2Dlod(tex, uv).r)
#define UNITY_DECLARE_SCREENSPACE_TEXTURE(tex) sampler2D tex; // as Unity's: many write none behind
#define UNITY_DECLARE_SCREENSPACE_SHADOWMAP(tex) sampler2D tex
#define UNITY_SAMPLE_SCREENSPACE_TEXTURE(tex, uv) tex2D(tex, uv)
#define UNITY_SAMPLE_SCREEN_SHADOW(tex, uv) (tex2Dproj(tex, uv).r)

#define UnityStereoTransformScreenSpaceTex(uv) uv
#define UnityStereoScreenSpaceUVAdjust(uv, scaleAndOffset) uv
#define TransformStereoScreenSpaceTex(uv, w) uv
#define UnityStereoClamp(uv, scaleAndOffset) uv
#endif
