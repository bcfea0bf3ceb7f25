// What sprites' vertices go through. limn draws sprites as meshes: none is flipped, tinted by its
// renderer or bent by bones.
#pragma once
#ifndef INPUT_CORE_2D_INCLUDED
#define INPUT_CORE_2D_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

#define unity_SpriteColor float4(1, 1, 1, 1)
#define unity_SpriteProps float4(1, 1, -1, -1) // xy: -1 where flipped
#define unity_SpriteFlip float2(1, 1)

// Fields of the author's Attributes and Varyings, from Unity 6.1 on
#define COMMON_2D_INPUTS                                                                           \
    float3 positionOS : POSITION;                                                                  \
    float2 uv : TEXCOORD0;                                                                         \
    float3 normal : NORMAL;                                                                        \
    UNITY_VERTEX_INPUT_INSTANCE_ID
#define COMMON_2D_NORMALS_INPUTS                                                                   \
    COMMON_2D_INPUTS                                                                               \
    float4 tangent : TANGENT;
#define COMMON_2D_OUTPUTS_SHARED                                                                   \
    float4 positionCS : SV_POSITION;                                                               \
    float2 uv : TEXCOORD0;                                                                         \
    UNITY_VERTEX_OUTPUT_STEREO
#define COMMON_2D_OUTPUTS COMMON_2D_OUTPUTS_SHARED
#define COMMON_2D_LIT_OUTPUTS                                                                      \
    COMMON_2D_OUTPUTS                                                                              \
    half2 lightingUV : TEXCOORD1;
#define COMMON_2D_NORMALS_OUTPUTS                                                                  \
    COMMON_2D_OUTPUTS_SHARED                                                                       \
    half3 normalWS : TEXCOORD1;                                                                    \
    half3 tangentWS : TEXCOORD2;                                                                   \
    half3 bitangentWS : TEXCOORD3;

#define UNITY_SKINNED_VERTEX_INPUTS
#define UNITY_SKINNED_VERTEX_COMPUTE(v)

float3 UnityFlipSprite(in float3 pos, in float2 flip) { return float3(pos.xy * flip, pos.z); }
void SetUpSpriteInstanceProperties() {}
#endif
