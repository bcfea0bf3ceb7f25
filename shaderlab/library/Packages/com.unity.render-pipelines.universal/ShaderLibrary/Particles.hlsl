// What particle shaders do with their colours and coordinates. A shader that calls
// InitParticleParams declares VaryingsParticle and _BaseColor before.
#pragma once
#ifndef UNIVERSAL_PARTICLES_INCLUDED
#define UNIVERSAL_PARTICLES_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareOpaqueTexture.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/ParticlesInstancing.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceInput.hlsl"

struct ParticleParams
{
    float4 positionWS;
    float4 vertexColor;
    float4 projectedPosition;
    float4 baseColor;
    float3 blendUv;
    float2 uv;
};

void InitParticleParams(VaryingsParticle input, out ParticleParams output)
{
    output = (ParticleParams)0;
#ifndef PARTICLES_EDITOR_META_PASS
#if defined(_SOFTPARTICLES_ON) || defined(_FADING_ON) || defined(_DISTORTION_ON)
    output.projectedPosition = input.projectedPosition;
#endif
    output.baseColor = _BaseColor;
    output.positionWS = input.positionWS;
#endif
#ifdef _FLIPBOOKBLENDING_ON
    output.blendUv = input.texcoord2AndBlend;
#endif
    output.vertexColor = input.color;
    output.uv = input.texcoord;
}

// How a fade enters the colour, by the shader's way of blending.
#ifdef _ALPHAPREMULTIPLY_ON
#define ALBEDO_MUL albedo
#define SOFT_PARTICLE_MUL_ALBEDO(albedo, val) albedo * val
#else
#define ALBEDO_MUL albedo.a
#ifdef _ALPHAMODULATE_ON
#define SOFT_PARTICLE_MUL_ALBEDO(albedo, val) \
    float4(lerp(float3(1, 1, 1), albedo.rgb, albedo.a * val), albedo.a * val)
#else
#define SOFT_PARTICLE_MUL_ALBEDO(albedo, val) albedo * float4(1, 1, 1, val)
#endif
#endif

// The texture's colour and the particle's, by the material's Color Mode. colorAddSubDiff: how much
// of the particle's is added, and whether the sum's sign is dropped.
float4 MixParticleColor(float4 baseColor, float4 particleColor, float4 colorAddSubDiff)
{
    float3 base = baseColor.rgb;
    float3 particle = particleColor.rgb;
#if defined(_COLOROVERLAY_ON)
    float3 light = 1.0 - 2.0 * (1.0 - base) * (1.0 - particle);
    float3 color = lerp(light, 2.0 * base * particle, step(base, 0.5));
#elif defined(_COLORCOLOR_ON)
    float3 color = HsvToRgb(float3(RgbToHsv(particle).xy, RgbToHsv(base).z));
#elif defined(_COLORADDSUBDIFF_ON)
    float3 sum = base + particle * colorAddSubDiff.x;
    float3 color = lerp(sum, abs(sum), colorAddSubDiff.y);
#else
    float3 color = base * particle;
#endif
    return float4(color, baseColor.a * particleColor.a);
}

// Distance along the view axis of what is drawn at a place of the screen.
float limn_SceneEyeDepth(float4 projection)
{
    float depth = SampleSceneDepth(projection.xy / projection.w);
    return unity_OrthoParams.w == 0.0 ? LinearEyeDepth(depth, _ZBufferParams)
                                      : LinearDepthToEyeDepth(depth);
}
float limn_SoftFade(float near, float far, float sceneZ, float thisZ)
{
    return near > 0.0 || far > 0.0 ? saturate(far * (sceneZ - near - thisZ)) : 1.0;
}

// Fades where the scene is close behind: 0 at near, 1 a distance of 1/far later. projection: as
// ComputeScreenPos gives it.
float SoftParticles(float near, float far, float4 projection)
{
    float thisZ = LinearEyeDepth(projection.z / projection.w, _ZBufferParams);
    return limn_SoftFade(near, far, limn_SceneEyeDepth(projection), thisZ);
}
float SoftParticles(float near, float far, ParticleParams params)
{
    float thisZ = LinearEyeDepth(params.positionWS.xyz, GetWorldToViewMatrix());
    return limn_SoftFade(near, far, limn_SceneEyeDepth(params.projectedPosition), thisZ);
}

// Fades where the camera is close: 0 at near, 1 a distance of 1/far later.
float CameraFade(float near, float far, float4 projection)
{
    return saturate((LinearEyeDepth(projection.z / projection.w, _ZBufferParams) - near) * far);
}

float3 AlphaModulateAndPremultiply(float3 albedo, float alpha)
{
#ifdef _ALPHAMODULATE_ON
    return AlphaModulate(albedo, alpha);
#else
    return AlphaPremultiply(albedo, alpha);
#endif
}

// What lies behind, seen through the particle as through bent glass.
float3 Distortion(float4 baseColor, float3 normal, float strength, float blend, float4 projection)
{
    float2 uv = projection.xy / projection.w + normal.xy * strength * baseColor.a;
    return lerp(SampleSceneColor(uv), baseColor.rgb, saturate(baseColor.a - blend));
}

// blendUv: of the next frame of a flipbook, and how far it has come.
float4 BlendTexture(TEXTURE2D_PARAM(tex, smp), float2 uv, float3 blendUv)
{
    float4 color = SAMPLE_TEXTURE2D(tex, smp, uv);
#ifdef _FLIPBOOKBLENDING_ON
    color = lerp(color, SAMPLE_TEXTURE2D(tex, smp, blendUv.xy), blendUv.z);
#endif
    return color;
}

float3 SampleNormalTS(float2 uv, float3 blendUv, TEXTURE2D_PARAM(bumpMap, smp), float scale = 1.0)
{
#ifdef _NORMALMAP
    return UnpackNormalScale(BlendTexture(TEXTURE2D_ARGS(bumpMap, smp), uv, blendUv), scale);
#else
    return float3(0, 0, 1);
#endif
}

float4 GetParticleColor(float4 color) { return color; }

void GetParticleTexcoords(out float2 outputTexcoord, out float3 outputTexcoord2AndBlend,
                          float4 inputTexcoords, float inputBlend)
{
    outputTexcoord = inputTexcoords.xy;
#ifdef _FLIPBOOKBLENDING_ON
    outputTexcoord2AndBlend = float3(inputTexcoords.zw, inputBlend);
#else
    outputTexcoord2AndBlend = float3(inputTexcoords.xy, 0.5);
#endif
}
void GetParticleTexcoords(out float2 outputTexcoord, float2 inputTexcoord)
{
    outputTexcoord = inputTexcoord;
}
#endif
