// Properties of Particles/Lit, and the surface they make.
#pragma once
#ifndef UNIVERSAL_PARTICLES_LIT_INPUT_INCLUDED
#define UNIVERSAL_PARTICLES_LIT_INPUT_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/Shaders/Particles/ParticlesInput.hlsl"

CBUFFER_START(UnityPerMaterial)
float4 _SoftParticleFadeParams; // distance before a surface where fading ends, 1 / length of it
float4 _CameraFadeParams;       // the same before the camera
float4 _BaseMap_ST;
half4 _BaseColor;
half4 _EmissionColor;
half4 _BaseColorAddSubDiff;
half _Cutoff;
half _Metallic;
half _Smoothness;
half _BumpScale;
half _DistortionStrengthScaled;
half _DistortionBlend;
half _Surface;
CBUFFER_END
TEXTURE2D(_MetallicGlossMap);
SAMPLER(sampler_MetallicGlossMap);
#include "limn/ParticleSurface.hlsl"

void InitializeParticleLitSurfaceData(ParticleParams params, out SurfaceData outSurfaceData)
{
    half4 albedo = SampleAlbedo(TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap), params);
    outSurfaceData = (SurfaceData)0;
    outSurfaceData.normalTS = SampleNormalTS(
        params.uv, params.blendUv, TEXTURE2D_ARGS(_BumpMap, sampler_BumpMap), _BumpScale);
    outSurfaceData.metallic = _Metallic;
    outSurfaceData.smoothness = _Smoothness;
#ifdef _METALLICSPECGLOSSMAP
    half4 gloss = BlendTexture(TEXTURE2D_ARGS(_MetallicGlossMap, sampler_MetallicGlossMap),
                               params.uv, params.blendUv);
    outSurfaceData.metallic = gloss.r;
    outSurfaceData.smoothness = gloss.a * _Smoothness;
#endif
    outSurfaceData.albedo = AlphaModulate(
        limn_ParticleDistorted(albedo, outSurfaceData.normalTS, params), albedo.a);
    outSurfaceData.alpha = albedo.a;
    outSurfaceData.emission = limn_ParticleEmission(params);
    outSurfaceData.occlusion = 1.0;
    outSurfaceData.clearCoatSmoothness = 1.0;
}
#endif
