// Properties of Particles/Unlit, and the surface they make.
#pragma once
#ifndef UNIVERSAL_PARTICLES_UNLIT_INPUT_INCLUDED
#define UNIVERSAL_PARTICLES_UNLIT_INPUT_INCLUDED
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
half _DistortionStrengthScaled;
half _DistortionBlend;
half _Surface;
CBUFFER_END
#define _BumpScale 1.0
#define limn_ParticleIsUnlit
#include "limn/ParticleSurface.hlsl"
#endif
