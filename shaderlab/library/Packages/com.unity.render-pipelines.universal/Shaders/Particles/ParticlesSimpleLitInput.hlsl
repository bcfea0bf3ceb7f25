// Properties of Particles/Simple Lit, and the surface they make.
#pragma once
#ifndef UNIVERSAL_PARTICLES_SIMPLE_LIT_INPUT_INCLUDED
#define UNIVERSAL_PARTICLES_SIMPLE_LIT_INPUT_INCLUDED
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
half4 _SpecColor;
half _Smoothness;
half _DistortionStrengthScaled;
half _DistortionBlend;
half _Surface;
CBUFFER_END
TEXTURE2D(_SpecGlossMap);
SAMPLER(sampler_SpecGlossMap);
#define _BumpScale 1.0
#include "limn/ParticleSurface.hlsl"

half4 SampleSpecularSmoothness(float2 uv, float3 blendUv, half alpha, half4 specColor,
                               TEXTURE2D_PARAM(specGlossMap, sampler_specGlossMap))
{
#if defined(_SPECGLOSSMAP)
    half4 gloss =
        BlendTexture(TEXTURE2D_ARGS(specGlossMap, sampler_specGlossMap), uv, blendUv);
#elif defined(_SPECULAR_COLOR)
    half4 gloss = specColor;
#else
    half4 gloss = half4(0, 0, 0, 1);
#endif
#ifdef _GLOSSINESS_FROM_BASE_ALPHA
    gloss.a = alpha;
#endif
    return gloss;
}
#endif
