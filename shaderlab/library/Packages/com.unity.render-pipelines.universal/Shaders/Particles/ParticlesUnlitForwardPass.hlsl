// Particles as bright as they are.
#pragma once
#ifndef UNIVERSAL_PARTICLES_UNLIT_FORWARD_PASS_INCLUDED
#define UNIVERSAL_PARTICLES_UNLIT_FORWARD_PASS_INCLUDED
#include "limn/ParticlePass.hlsl"

void InitializeInputData(VaryingsParticle input, SurfaceData surfaceData, out InputData inputData)
{
    InitializeInputData(input, surfaceData.normalTS, inputData);
}
void InitializeSurfaceData(ParticleParams particleParams, out SurfaceData surfaceData)
{
    half4 albedo = SampleAlbedo(TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap), particleParams);
    surfaceData = (SurfaceData)0;
    surfaceData.normalTS = SampleNormalTS(particleParams.uv, particleParams.blendUv,
                                          TEXTURE2D_ARGS(_BumpMap, sampler_BumpMap));
    surfaceData.albedo = limn_ParticleDistorted(albedo, surfaceData.normalTS, particleParams);
    surfaceData.alpha = albedo.a;
    surfaceData.emission = limn_ParticleEmission(particleParams);
    surfaceData.smoothness = 1.0;
    surfaceData.occlusion = 1.0;
    surfaceData.clearCoatSmoothness = 1.0;
}

VaryingsParticle vertParticleUnlit(AttributesParticle input) { return limn_ParticleVertex(input); }
half4 fragParticleUnlit(VaryingsParticle input) : SV_Target
{
    ParticleParams params;
    InitParticleParams(input, params);
    SurfaceData surfaceData;
    InitializeSurfaceData(params, surfaceData);
    InputData inputData;
    InitializeInputData(input, surfaceData, inputData);
    return limn_ParticleFogged(UniversalFragmentUnlit(inputData, surfaceData), inputData);
}
#endif
