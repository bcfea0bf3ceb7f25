// What particles' vertices hold, and what crosses to their fragments.
#pragma once
#ifndef UNIVERSAL_PARTICLES_INPUT_INCLUDED
#define UNIVERSAL_PARTICLES_INPUT_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"

#ifdef _FLIPBOOKBLENDING_ON
#define limn_PARTICLE_COORDS \
    float4 texcoords : TEXCOORD0; \
    float texcoordBlend : TEXCOORD1;
#else
#define limn_PARTICLE_COORDS float2 texcoords : TEXCOORD0;
#endif

struct AttributesParticle
{
    float4 positionOS : POSITION;
    half4 color : COLOR;
    limn_PARTICLE_COORDS
#ifndef PARTICLES_EDITOR_META_PASS
    float3 normalOS : NORMAL;
    float4 tangentOS : TANGENT;
#endif
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct VaryingsParticle
{
    float4 clipPos : SV_POSITION;
    float2 texcoord : TEXCOORD0;
    half4 color : COLOR;
#ifdef _FLIPBOOKBLENDING_ON
    float3 texcoord2AndBlend : TEXCOORD5;
#endif
#ifndef PARTICLES_EDITOR_META_PASS
    float4 positionWS : TEXCOORD1; // w: fog
#ifdef _NORMALMAP
    half4 normalWS : TEXCOORD2; // w: view direction
    half4 tangentWS : TEXCOORD3;
    half4 bitangentWS : TEXCOORD4;
#else
    half3 normalWS : TEXCOORD2;
    half3 viewDirWS : TEXCOORD3;
#endif
#if defined(_SOFTPARTICLES_ON) || defined(_FADING_ON) || defined(_DISTORTION_ON)
    float4 projectedPosition : TEXCOORD6;
#endif
#ifdef REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR
    float4 shadowCoord : TEXCOORD7;
#endif
    half3 vertexSH : TEXCOORD8;
#endif
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

struct AttributesDepthOnlyParticle
{
    float4 vertex : POSITION;
    half4 color : COLOR;
    limn_PARTICLE_COORDS
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct VaryingsDepthOnlyParticle
{
    float4 clipPos : SV_POSITION;
    float2 texcoord : TEXCOORD0;
    half4 color : COLOR;
#ifdef _FLIPBOOKBLENDING_ON
    float3 texcoord2AndBlend : TEXCOORD5;
#endif
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

struct AttributesDepthNormalsParticle
{
    float4 vertex : POSITION;
    half4 color : COLOR;
    limn_PARTICLE_COORDS
    float3 normal : NORMAL;
    float4 tangent : TANGENT;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct VaryingsDepthNormalsParticle
{
    float4 clipPos : SV_POSITION;
    float2 texcoord : TEXCOORD0;
    half4 color : COLOR;
#ifdef _FLIPBOOKBLENDING_ON
    float3 texcoord2AndBlend : TEXCOORD5;
#endif
    float3 normalWS : TEXCOORD2;
#ifdef _NORMALMAP
    float3 tangentWS : TEXCOORD3;
    float3 bitangentWS : TEXCOORD4;
#endif
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};
#endif
