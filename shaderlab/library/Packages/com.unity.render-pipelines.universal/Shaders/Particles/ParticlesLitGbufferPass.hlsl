// The deferred pass of ParticlesLitInput.hlsl.
#pragma once
#ifndef UNIVERSAL_PARTICLES_GBUFFER_LIT_PASS_INCLUDED
#define UNIVERSAL_PARTICLES_GBUFFER_LIT_PASS_INCLUDED
#include "limn/ParticlePass.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityGBuffer.hlsl"

VaryingsParticle ParticlesGBufferVertex(AttributesParticle input)
{
    return limn_ParticleVertex(input);
}
FragmentOutput ParticlesGBufferFragment(VaryingsParticle input)
{
    ParticleParams params;
    InitParticleParams(input, params);
    SurfaceData surface;
    InitializeParticleLitSurfaceData(params, surface);
    InputData data;
    InitializeInputData(input, surface.normalTS, data);
    BRDFData brdf;
    InitializeBRDFData(surface, brdf);
    half3 light = GlobalIllumination(brdf, data.bakedGI, surface.occlusion, data.positionWS,
                                     data.normalWS, data.viewDirectionWS);
    return BRDFDataToGbuffer(brdf, data, surface.smoothness, surface.emission + light,
                             surface.occlusion);
}
#endif
