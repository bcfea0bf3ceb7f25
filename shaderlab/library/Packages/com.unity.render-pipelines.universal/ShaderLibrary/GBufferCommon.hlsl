// What deferred passes store, by Unity 6's names. limn draws forward; the names are there for shaders
// that have such a pass.
#pragma once
#ifndef UNIVERSAL_GBUFFERCOMMON_INCLUDED
#define UNIVERSAL_GBUFFERCOMMON_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityGBuffer.hlsl"

#define GBUFFER_IDX_RGB_BASECOLOR_A_FLAGS 0
#define GBUFFER_IDX_RGB_SPECULAR_R_METALLIC_A_OCCLUSION 1
#define GBUFFER_IDX_RGB_NORMALS_A_SMOOTHNESS 2

struct GBufferData
{
    half3 baseColor;
    half smoothness;
    half3 specularColor; // r: metallic, without kMaterialFlagSpecularSetup
    half occlusion;
    float3 normalWS;
    uint materialFlags;
    float depth;
    half4 shadowMask;
    uint meshRenderingLayers;
};

float PackGBufferMaterialFlags(uint materialFlags) { return PackMaterialFlags(materialFlags); }
uint UnpackGBufferMaterialFlags(float packed) { return UnpackMaterialFlags(packed); }
half3 PackGBufferNormal(half3 normalWS) { return PackNormal(normalWS); }
half3 UnpackGBufferNormal(half3 packed) { return UnpackNormal(packed); }
#endif
