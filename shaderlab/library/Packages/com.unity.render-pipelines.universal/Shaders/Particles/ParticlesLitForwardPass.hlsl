// Physically based lighting of particles.
#pragma once
#ifndef UNIVERSAL_PARTICLES_FORWARD_LIT_PASS_INCLUDED
#define UNIVERSAL_PARTICLES_FORWARD_LIT_PASS_INCLUDED
#include "limn/ParticlePass.hlsl"

VaryingsParticle ParticlesLitVertex(AttributesParticle input) { return limn_ParticleVertex(input); }
half4 ParticlesLitFragment(VaryingsParticle input) : SV_Target
{
    ParticleParams params;
    InitParticleParams(input, params);
    SurfaceData surfaceData;
    InitializeParticleLitSurfaceData(params, surfaceData);
    InputData inputData;
    InitializeInputData(input, surfaceData.normalTS, inputData);
    return limn_ParticleFogged(UniversalFragmentPBR(inputData, surfaceData), inputData);
}
#endif
