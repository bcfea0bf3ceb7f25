// Shadows of particles: what is cut out throws none; what is transparent throws one where it is at
// least half opaque.
#pragma once
#ifndef UNITY_STANDARD_PARTICLE_SHADOW_INCLUDED
#define UNITY_STANDARD_PARTICLE_SHADOW_INCLUDED
#if defined(_REQUIRE_UV2) && !defined(_FLIPBOOK_BLENDING)
#define _FLIPBOOK_BLENDING 1
#endif
#include "UnityCG.cginc"
#include "UnityShaderVariables.cginc"
#include "UnityStandardConfig.cginc"
#include "UnityStandardUtils.cginc"
#include "UnityStandardParticleInstancing.cginc"
#include "limn/ParticleFlipbook.hlsl"

half _Metallic;
#ifdef _METALLICGLOSSMAP
sampler2D _MetallicGlossMap;
#endif

half MetallicSetup_ShadowGetOneMinusReflectivity(half2 uv)
{
#ifdef _METALLICGLOSSMAP
    return OneMinusReflectivityFromMetallic(tex2D(_MetallicGlossMap, uv).r);
#else
    return OneMinusReflectivityFromMetallic(_Metallic);
#endif
}

struct VertexOutputShadowCaster
{
    V2F_SHADOW_CASTER_NOPOS
    limn_FLIPBOOK_COORDS(1, 2)
    fixed4 color : TEXCOORD3;
};

void vertParticleShadowCaster(VertexInput v, out VertexOutputShadowCaster o,
                              out float4 opos : SV_POSITION)
{
    UNITY_INITIALIZE_OUTPUT(VertexOutputShadowCaster, o);
    TRANSFER_SHADOW_CASTER_NOPOS(o, opos)
    limn_TRANSFER_FLIPBOOK(v, o)
    o.color = v.color;
}

half4 fragParticleShadowCaster(VertexOutputShadowCaster i) : SV_Target
{
    half alpha = limn_FLIPBOOK_ALPHA(i);
#ifdef _ALPHATEST_ON
    clip(alpha - _Cutoff);
#endif
#if defined(_ALPHABLEND_ON) || defined(_ALPHAPREMULTIPLY_ON)
    half seen;
    PreMultiplyAlpha(half3(0, 0, 0), alpha, MetallicSetup_ShadowGetOneMinusReflectivity(i.texcoord),
                     seen);
    clip(seen - 0.5);
#endif
    SHADOW_CASTER_FRAGMENT(i)
}
#endif
