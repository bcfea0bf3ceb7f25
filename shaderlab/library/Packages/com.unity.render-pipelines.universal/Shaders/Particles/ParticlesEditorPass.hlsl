// How the editor draws particles that are chosen or clicked on.
#pragma once
#ifndef UNIVERSAL_PARTICLES_EDITOR_PASS_INCLUDED
#define UNIVERSAL_PARTICLES_EDITOR_PASS_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/Shaders/Particles/ParticlesInput.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Particles.hlsl"

float _ObjectId;
float _PassValue;
float4 _SelectionID;

VaryingsParticle vertParticleEditor(AttributesParticle input)
{
    VaryingsParticle output = (VaryingsParticle)0;
#ifndef _FLIPBOOKBLENDING_ON
    GetParticleTexcoords(output.texcoord, input.texcoords.xy);
#else
    GetParticleTexcoords(output.texcoord, output.texcoord2AndBlend, input.texcoords,
                         input.texcoordBlend);
#endif
    output.clipPos = TransformObjectToHClip(input.positionOS.xyz);
    output.color = GetParticleColor(input.color);
    return output;
}
void fragParticleSceneClip(VaryingsParticle input)
{
#ifdef _ALPHATEST_ON
    ParticleParams params;
    InitParticleParams(input, params);
    half4 texel =
        BlendTexture(TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap), params.uv, params.blendUv);
    clip(MixParticleColor(texel * _BaseColor, input.color, _BaseColorAddSubDiff).a - _Cutoff);
#endif
}
half4 fragParticleSceneHighlight(VaryingsParticle input) : SV_Target
{
    fragParticleSceneClip(input);
    return float4(_ObjectId, _PassValue, 1.0, 1.0);
}
half4 fragParticleScenePicking(VaryingsParticle input) : SV_Target
{
    fragParticleSceneClip(input);
    return _SelectionID;
}
#endif
