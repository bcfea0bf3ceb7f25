// Conventions of the device and spellings of HLSL that both shader libraries share.
#pragma once

// Clip space has y up and z from 1 (near) to 0 (far), or the other way round
// (ShaderCompilerOptions::usesReversedZBuffer); y = 1 in clip space is a target's first row.
#define UNITY_UV_STARTS_AT_TOP 1
#if defined(LIMN_STANDARD_Z)
#define UNITY_NEAR_CLIP_VALUE (0.0)
#define UNITY_RAW_FAR_CLIP_VALUE (1.0)
#else
#define UNITY_REVERSED_Z 1
#define UNITY_NEAR_CLIP_VALUE (1.0)
#define UNITY_RAW_FAR_CLIP_VALUE (0.0)
#endif

#define CBUFFER_START(name) cbuffer name {
#define CBUFFER_END };

#define UNITY_BRANCH [branch]
#define UNITY_FLATTEN [flatten]
#define UNITY_UNROLL [unroll]
#define UNITY_UNROLLX(n) [unroll(n)]
#define UNITY_LOOP [loop]

// Instances are told apart by limn_DrawIndex, and nothing is left to do; but for those that a
// function of the shader's own places (limn/PerDraw.hlsl has the rest).
#ifdef UNITY_INSTANCING_PROCEDURAL_FUNC
#define UNITY_PROCEDURAL_INSTANCING_ENABLED
static uint unity_InstanceID;
#define UNITY_VERTEX_INPUT_INSTANCE_ID uint instanceID : SV_InstanceID;
#define UNITY_SETUP_INSTANCE_ID(input) limn_SetupInstance((input).instanceID);
#define UNITY_TRANSFER_INSTANCE_ID(input, output) (output).instanceID = (input).instanceID;
#define UNITY_GET_INSTANCE_ID(input) ((input).instanceID)
#else
#define UNITY_VERTEX_INPUT_INSTANCE_ID
#define UNITY_SETUP_INSTANCE_ID(input)
#define UNITY_TRANSFER_INSTANCE_ID(input, output)
#define UNITY_GET_INSTANCE_ID(input) 0u
#define unity_InstanceID 0u
#endif
// There is one eye.
#define UNITY_VERTEX_OUTPUT_STEREO
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output)
#define UNITY_TRANSFER_VERTEX_OUTPUT_STEREO(input, output)
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)
#define UNITY_VERTEX_OUTPUT_STEREO_EYE_INDEX
#define UNITY_INITIALIZE_OUTPUT_STEREO_EYE_INDEX(output)
#define DEFAULT_UNITY_VERTEX_OUTPUT_STEREO_EYE_INDEX
#define DEFAULT_UNITY_INITIALIZE_OUTPUT_STEREO_EYE_INDEX(output)
#define DEFAULT_UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)
// A uniform that nobody sets, rather than a macro: authors declare it as well.
cbuffer UnityStereoEyeIndex
{
    int unity_StereoEyeIndex;
};

// Loose uniforms rather than a buffer: many authors write a semicolon after each property, which
// cannot stand in a buffer by itself.
#define UNITY_INSTANCING_BUFFER_START(buf)
#define UNITY_INSTANCING_BUFFER_END(buf)
#define UNITY_DEFINE_INSTANCED_PROP(type, var) type var;
#define UNITY_ACCESS_INSTANCED_PROP(buf, var) var

#define TRANSFORM_TEX(uv, name) ((uv).xy * name##_ST.xy + name##_ST.zw)
