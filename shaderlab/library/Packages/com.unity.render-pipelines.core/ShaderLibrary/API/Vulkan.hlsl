#pragma once
#include "limn/Platform.hlsl"

#define PLATFORM_SUPPORT_GATHER
#define PLATFORM_SUPPORTS_NATIVE_RENDERPASS

#define VERTEXID_SEMANTIC SV_VertexID
#define INSTANCEID_SEMANTIC SV_InstanceID
#define SV_POSITION_QUALIFIERS
#define DEPTH_OFFSET_SEMANTIC SV_Depth
#define FRONT_FACE_SEMANTIC SV_IsFrontFace
#define FRONT_FACE_TYPE bool
#define IS_FRONT_VFACE(value, front, back) ((value) ? (front) : (back))

#define ZERO_INITIALIZE(type, name) name = (type)0;
#define ZERO_INITIALIZE_ARRAY(type, name, size) \
    { for (int limn_i = 0; limn_i < size; limn_i++) name[limn_i] = (type)0; }

#define TEXTURE2D(name) Texture2D name
#define TEXTURE2D_ARRAY(name) Texture2DArray name
#define TEXTURECUBE(name) TextureCube name
#define TEXTURECUBE_ARRAY(name) TextureCubeArray name
#define TEXTURE3D(name) Texture3D name
#define TEXTURE2D_FLOAT(name) TEXTURE2D(name)
#define TEXTURE2D_HALF(name) TEXTURE2D(name)
#define TEXTURE2D_ARRAY_FLOAT(name) TEXTURE2D_ARRAY(name)
#define TEXTURE2D_ARRAY_HALF(name) TEXTURE2D_ARRAY(name)
#define TEXTURECUBE_FLOAT(name) TEXTURECUBE(name)
#define TEXTURECUBE_HALF(name) TEXTURECUBE(name)
#define TEXTURE3D_FLOAT(name) TEXTURE3D(name)
#define TEXTURE3D_HALF(name) TEXTURE3D(name)
#define TEXTURE2D_SHADOW(name) TEXTURE2D(name)
#define TEXTURE2D_ARRAY_SHADOW(name) TEXTURE2D_ARRAY(name)
#define SAMPLER(name) SamplerState name
#define SAMPLER_CMP(name) SamplerComparisonState name

#define TEXTURE2D_MSAA(type, name) Texture2DMS<type> name
#define TEXTURECUBE_SHADOW(name) TEXTURECUBE(name)
#define TEXTURECUBE_ARRAY_FLOAT(name) TEXTURECUBE_ARRAY(name)
#define TEXTURECUBE_ARRAY_HALF(name) TEXTURECUBE_ARRAY(name)
#define TEXTURECUBE_ARRAY_SHADOW(name) TEXTURECUBE_ARRAY(name)
#define RW_TEXTURE2D(type, name) RWTexture2D<type> name
#define RW_TEXTURE2D_ARRAY(type, name) RWTexture2DArray<type> name
#define RW_TEXTURE3D(type, name) RWTexture3D<type> name

#define ASSIGN_SAMPLER(samplerName, samplerValue) samplerName = samplerValue

#define TEXTURE2D_PARAM(name, smp) TEXTURE2D(name), SAMPLER(smp)
#define TEXTURE2D_ARRAY_PARAM(name, smp) TEXTURE2D_ARRAY(name), SAMPLER(smp)
#define TEXTURECUBE_PARAM(name, smp) TEXTURECUBE(name), SAMPLER(smp)
#define TEXTURE3D_PARAM(name, smp) TEXTURE3D(name), SAMPLER(smp)
#define TEXTURE2D_SHADOW_PARAM(name, smp) TEXTURE2D(name), SAMPLER_CMP(smp)
#define TEXTURECUBE_ARRAY_PARAM(name, smp) TEXTURECUBE_ARRAY(name), SAMPLER(smp)
#define TEXTURE2D_ARRAY_SHADOW_PARAM(name, smp) TEXTURE2D_ARRAY(name), SAMPLER_CMP(smp)
#define TEXTURE2D_HALF_PARAM(name, smp) TEXTURE2D(name), SAMPLER(smp)
#define TEXTURE2D_FLOAT_PARAM(name, smp) TEXTURE2D(name), SAMPLER(smp)
#define TEXTURE2D_ARGS(name, smp) name, smp
#define TEXTURE2D_ARRAY_ARGS(name, smp) name, smp
#define TEXTURECUBE_ARRAY_ARGS(name, smp) name, smp
#define TEXTURE2D_ARRAY_SHADOW_ARGS(name, smp) name, smp
#define TEXTURECUBE_ARGS(name, smp) name, smp
#define TEXTURE3D_ARGS(name, smp) name, smp
#define TEXTURE2D_SHADOW_ARGS(name, smp) name, smp

#define SAMPLE_TEXTURE2D(name, smp, uv) name.Sample(smp, uv)
#define SAMPLE_TEXTURE2D_LOD(name, smp, uv, lod) name.SampleLevel(smp, uv, lod)
#define SAMPLE_TEXTURE2D_BIAS(name, smp, uv, bias) name.SampleBias(smp, uv, bias)
#define SAMPLE_TEXTURE2D_GRAD(name, smp, uv, dx, dy) name.SampleGrad(smp, uv, dx, dy)
#define SAMPLE_TEXTURE2D_ARRAY(name, smp, uv, index) name.Sample(smp, float3(uv, index))
#define SAMPLE_TEXTURE2D_ARRAY_LOD(name, smp, uv, index, lod) \
    name.SampleLevel(smp, float3(uv, index), lod)
#define SAMPLE_TEXTURE2D_ARRAY_BIAS(name, smp, uv, index, bias) \
    name.SampleBias(smp, float3(uv, index), bias)
#define SAMPLE_TEXTURE2D_ARRAY_GRAD(name, smp, uv, index, dx, dy) \
    name.SampleGrad(smp, float3(uv, index), dx, dy)
#define SAMPLE_TEXTURECUBE(name, smp, direction) name.Sample(smp, direction)
#define SAMPLE_TEXTURECUBE_LOD(name, smp, direction, lod) name.SampleLevel(smp, direction, lod)
#define SAMPLE_TEXTURECUBE_BIAS(name, smp, direction, bias) name.SampleBias(smp, direction, bias)
#define SAMPLE_TEXTURECUBE_ARRAY(name, smp, direction, index) \
    name.Sample(smp, float4(direction, index))
#define SAMPLE_TEXTURECUBE_ARRAY_LOD(name, smp, direction, index, lod) \
    name.SampleLevel(smp, float4(direction, index), lod)
#define SAMPLE_TEXTURE3D(name, smp, uvw) name.Sample(smp, uvw)
#define SAMPLE_TEXTURE3D_LOD(name, smp, uvw, lod) name.SampleLevel(smp, uvw, lod)
#define SAMPLE_TEXTURE2D_SHADOW(name, smp, uvz) name.SampleCmpLevelZero(smp, (uvz).xy, (uvz).z)
#define SAMPLE_TEXTURE2D_ARRAY_SHADOW(name, smp, uvz, index) \
    name.SampleCmpLevelZero(smp, float3((uvz).xy, index), (uvz).z)
#define SAMPLE_TEXTURECUBE_SHADOW(name, smp, directionZ) \
    name.SampleCmpLevelZero(smp, (directionZ).xyz, (directionZ).w)
#define SAMPLE_DEPTH_TEXTURE(name, smp, uv) SAMPLE_TEXTURE2D(name, smp, uv).r
#define SAMPLE_DEPTH_TEXTURE_LOD(name, smp, uv, lod) SAMPLE_TEXTURE2D_LOD(name, smp, uv, lod).r

#define LOAD_TEXTURE2D(name, texel) name.Load(int3(texel, 0))
#define LOAD_TEXTURE2D_LOD(name, texel, lod) name.Load(int3(texel, lod))
#define LOAD_TEXTURE2D_MSAA(name, texel, index) name.Load(texel, index)
#define LOAD_TEXTURE2D_ARRAY(name, texel, index) name.Load(int4(texel, index, 0))
#define LOAD_TEXTURE2D_ARRAY_LOD(name, texel, index, lod) name.Load(int4(texel, index, lod))
#define LOAD_TEXTURE3D_LOD(name, texel, lod) name.Load(int4(texel, lod))
#define LOAD_TEXTURE3D(name, texel) name.Load(int4(texel, 0))

#define GATHER_TEXTURE2D(name, smp, uv) name.Gather(smp, uv)
#define GATHER_TEXTURE2D_ARRAY(name, smp, uv, index) name.Gather(smp, float3(uv, index))
#define GATHER_TEXTURECUBE(name, smp, direction) name.Gather(smp, direction)
#define GATHER_RED_TEXTURE2D(name, smp, uv) name.GatherRed(smp, uv)
#define GATHER_GREEN_TEXTURE2D(name, smp, uv) name.GatherGreen(smp, uv)
#define GATHER_BLUE_TEXTURE2D(name, smp, uv) name.GatherBlue(smp, uv)
#define GATHER_ALPHA_TEXTURE2D(name, smp, uv) name.GatherAlpha(smp, uv)

// A pass's input attachments are textures under these names: nothing is kept within a tile.
#define FRAMEBUFFER_INPUT_HALF(index) Texture2D _UnityFBInput##index
#define FRAMEBUFFER_INPUT_FLOAT(index) Texture2D _UnityFBInput##index
#define FRAMEBUFFER_INPUT_INT(index) Texture2D<int4> _UnityFBInput##index
#define FRAMEBUFFER_INPUT_UINT(index) Texture2D<uint4> _UnityFBInput##index
#define FRAMEBUFFER_INPUT_HALF_MS(index) Texture2DMS<float4> _UnityFBInput##index
#define FRAMEBUFFER_INPUT_FLOAT_MS(index) Texture2DMS<float4> _UnityFBInput##index
#define FRAMEBUFFER_INPUT_INT_MS(index) Texture2DMS<int4> _UnityFBInput##index
#define FRAMEBUFFER_INPUT_UINT_MS(index) Texture2DMS<uint4> _UnityFBInput##index
#define LOAD_FRAMEBUFFER_INPUT(index, position) _UnityFBInput##index.Load(int3((position).xy, 0))
#define LOAD_FRAMEBUFFER_INPUT_MS(index, sample, position) \
    _UnityFBInput##index.Load(int2((position).xy), sample)

// The forms that follow the eye: with one eye, the plain ones.
#define TEXTURE2D_X(name) TEXTURE2D(name)
#define TEXTURE2D_X_FLOAT(name) TEXTURE2D(name)
#define TEXTURE2D_X_HALF(name) TEXTURE2D(name)
#define TEXTURE2D_X_PARAM(name, smp) TEXTURE2D_PARAM(name, smp)
#define TEXTURE2D_X_ARGS(name, smp) TEXTURE2D_ARGS(name, smp)
#define TEXTURE2D_X_UINT(name) Texture2D<uint> name
#define TEXTURE2D_X_UINT2(name) Texture2D<uint2> name
#define TEXTURE2D_X_MSAA(type, name) TEXTURE2D_MSAA(type, name)
#define RW_TEXTURE2D_X(type, name) RW_TEXTURE2D(type, name)
#define SAMPLE_TEXTURE2D_X_BIAS(name, smp, uv, bias) SAMPLE_TEXTURE2D_BIAS(name, smp, uv, bias)
#define SAMPLE_TEXTURE2D_X_GRAD(name, smp, uv, dx, dy) SAMPLE_TEXTURE2D_GRAD(name, smp, uv, dx, dy)
#define SAMPLE_DEPTH_TEXTURE_X(name, smp, uv) SAMPLE_DEPTH_TEXTURE(name, smp, uv)
#define LOAD_TEXTURE2D_X_MSAA(name, texel, index) LOAD_TEXTURE2D_MSAA(name, texel, index)
#define SAMPLE_TEXTURE2D_X(name, smp, uv) SAMPLE_TEXTURE2D(name, smp, uv)
#define SAMPLE_TEXTURE2D_X_LOD(name, smp, uv, lod) SAMPLE_TEXTURE2D_LOD(name, smp, uv, lod)
#define LOAD_TEXTURE2D_X(name, texel) LOAD_TEXTURE2D(name, texel)
#define LOAD_TEXTURE2D_X_LOD(name, texel, lod) LOAD_TEXTURE2D_LOD(name, texel, lod)
#define GATHER_TEXTURE2D_X(name, smp, uv) GATHER_TEXTURE2D(name, smp, uv)
#define GATHER_RED_TEXTURE2D_X(name, smp, uv) GATHER_RED_TEXTURE2D(name, smp, uv)
#define GATHER_GREEN_TEXTURE2D_X(name, smp, uv) GATHER_GREEN_TEXTURE2D(name, smp, uv)
#define GATHER_BLUE_TEXTURE2D_X(name, smp, uv) GATHER_BLUE_TEXTURE2D(name, smp, uv)
#define GATHER_ALPHA_TEXTURE2D_X(name, smp, uv) GATHER_ALPHA_TEXTURE2D(name, smp, uv)
#define FRAMEBUFFER_INPUT_X_HALF(index) FRAMEBUFFER_INPUT_HALF(index)
#define FRAMEBUFFER_INPUT_X_FLOAT(index) FRAMEBUFFER_INPUT_FLOAT(index)
#define FRAMEBUFFER_INPUT_X_INT(index) FRAMEBUFFER_INPUT_INT(index)
#define FRAMEBUFFER_INPUT_X_UINT(index) FRAMEBUFFER_INPUT_UINT(index)
#define FRAMEBUFFER_INPUT_X_HALF_MS(index) FRAMEBUFFER_INPUT_HALF_MS(index)
#define FRAMEBUFFER_INPUT_X_FLOAT_MS(index) FRAMEBUFFER_INPUT_FLOAT_MS(index)
#define FRAMEBUFFER_INPUT_X_INT_MS(index) FRAMEBUFFER_INPUT_INT_MS(index)
#define FRAMEBUFFER_INPUT_X_UINT_MS(index) FRAMEBUFFER_INPUT_UINT_MS(index)
#define LOAD_FRAMEBUFFER_INPUT_X(index, position) LOAD_FRAMEBUFFER_INPUT(index, position)
#define LOAD_FRAMEBUFFER_X_INPUT(index, position) LOAD_FRAMEBUFFER_INPUT(index, position)
#define LOAD_FRAMEBUFFER_INPUT_X_MS(index, sample, position) \
    LOAD_FRAMEBUFFER_INPUT_MS(index, sample, position)
#define COORD_TEXTURE2D_X(texel) texel
#define INDEX_TEXTURE2D_ARRAY_X(slot) slot
#define SCREENSPACE_TEXTURE(name) TEXTURE2D_X(name) // of older versions
#define UnityStereoTransformScreenSpaceTex(uv) uv
#define SLICE_ARRAY_INDEX 0
