// Passes that draw particles without their colour.
#pragma once
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Particles.hlsl"

#ifdef _FLIPBOOKBLENDING_ON
#define limn_PARTICLE_BLEND(input) input.texcoord2AndBlend
#define limn_TRANSFER_PARTICLE(input, output) \
    output.clipPos = TransformObjectToHClip(input.vertex.xyz); \
    output.color = GetParticleColor(input.color); \
    GetParticleTexcoords(output.texcoord, output.texcoord2AndBlend, input.texcoords, \
                         input.texcoordBlend);
#else
#define limn_PARTICLE_BLEND(input) float3(0, 0, 0)
#define limn_TRANSFER_PARTICLE(input, output) \
    output.clipPos = TransformObjectToHClip(input.vertex.xyz); \
    output.color = GetParticleColor(input.color); \
    GetParticleTexcoords(output.texcoord, input.texcoords.xy);
#endif

#ifdef _ALPHATEST_ON
#define limn_CLIP_PARTICLE(input) \
    AlphaDiscard(MixParticleColor(BlendTexture(TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap), \
                                               input.texcoord, limn_PARTICLE_BLEND(input)) * \
                                      _BaseColor, \
                                  input.color, _BaseColorAddSubDiff).a, _Cutoff);
#else
#define limn_CLIP_PARTICLE(input)
#endif
