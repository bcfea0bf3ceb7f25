// The deferred pass of ParticlesSimpleLitInput.hlsl.
#pragma once
#define UNIVERSAL_PARTICLES_GBUFFER_SIMPLE_LIT_PASS_INCLUDED
#include "limn/ParticlePass.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityGBuffer.hlsl"

VaryingsParticle ParticlesLitGBufferVertex(AttributesParticle input)
{
    return limn_ParticleVertex(input);
}
FragmentOutput ParticlesLitGBufferFragment(VaryingsParticle input)
{
    ParticleParams params;
    InitParticleParams(input, params);
    half4 albedo = SampleAlbedo(TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap), params);
    half4 gloss =
        SampleSpecularSmoothness(params.uv, params.blendUv, albedo.a, _SpecColor,
                                 TEXTURE2D_ARGS(_SpecGlossMap, sampler_SpecGlossMap));
    SurfaceData surface = (SurfaceData)0;
    surface.normalTS =
        SampleNormalTS(params.uv, params.blendUv, TEXTURE2D_ARGS(_BumpMap, sampler_BumpMap));
    surface.albedo = AlphaModulate(albedo.rgb, albedo.a);
    surface.alpha = albedo.a;
    surface.specular = gloss.rgb;
    surface.smoothness = gloss.a;
    surface.occlusion = 1.0;
    surface.emission = limn_ParticleEmission(params);
    InputData data;
    InitializeInputData(input, surface.normalTS, data);
    return SurfaceDataToGbuffer(surface, data, surface.emission + data.bakedGI * surface.albedo,
                                kLightingSimpleLit);
}
