// Blinn-Phong lighting of particles.
#pragma once
#ifndef UNIVERSAL_PARTICLES_FORWARD_SIMPLE_LIT_PASS_INCLUDED
#define UNIVERSAL_PARTICLES_FORWARD_SIMPLE_LIT_PASS_INCLUDED
#include "limn/ParticlePass.hlsl"

VaryingsParticle ParticlesLitVertex(AttributesParticle input) { return limn_ParticleVertex(input); }
half4 ParticlesLitFragment(VaryingsParticle input) : SV_Target
{
    ParticleParams params;
    InitParticleParams(input, params);
    half3 normalTS =
        SampleNormalTS(params.uv, params.blendUv, TEXTURE2D_ARGS(_BumpMap, sampler_BumpMap));
    half4 albedo = SampleAlbedo(TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap), params);
    half4 modulated = half4(AlphaModulate(albedo.rgb, albedo.a), albedo.a);
    half4 gloss =
        SampleSpecularSmoothness(params.uv, params.blendUv, albedo.a, _SpecColor,
                                 TEXTURE2D_ARGS(_SpecGlossMap, sampler_SpecGlossMap));
    InputData inputData;
    InitializeInputData(input, normalTS, inputData);
    half4 color = UniversalFragmentBlinnPhong(
        inputData, limn_ParticleDistorted(modulated, normalTS, params), gloss, gloss.a,
        limn_ParticleEmission(params), albedo.a, normalTS);
    return limn_ParticleFogged(color, inputData);
}
#endif
