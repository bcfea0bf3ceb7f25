// The Standard shader's shadow caster. What is cut out throws no shadow; what is transparent throws
// one where it is at least half opaque.
#pragma once
#ifndef UNITY_STANDARD_SHADOW_INCLUDED
#define UNITY_STANDARD_SHADOW_INCLUDED
#include "UnityCG.cginc"
#include "UnityShaderVariables.cginc"
#include "UnityStandardConfig.cginc"
#include "UnityStandardUtils.cginc"

half4 _Color;
half _Cutoff;
sampler2D _MainTex;
float4 _MainTex_ST;

struct VertexInput
{
    float4 vertex : POSITION;
    float3 normal : NORMAL;
    float2 uv0 : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct limn_ShadowVaryings
{
    V2F_SHADOW_CASTER;
    float2 tex : TEXCOORD1;
};

limn_ShadowVaryings vertShadowCaster(VertexInput v)
{
    limn_ShadowVaryings o;
    UNITY_INITIALIZE_OUTPUT(limn_ShadowVaryings, o);
    TRANSFER_SHADOW_CASTER_NORMALOFFSET(o)
    o.tex = TRANSFORM_TEX(v.uv0, _MainTex);
    return o;
}

half4 fragShadowCaster(limn_ShadowVaryings i) : SV_Target
{
#if defined(_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A)
    half alpha = _Color.a;
#else
    half alpha = tex2D(_MainTex, i.tex).a * _Color.a;
#endif
#if defined(_ALPHATEST_ON)
    clip(alpha - _Cutoff);
#elif defined(_ALPHABLEND_ON) || defined(_ALPHAPREMULTIPLY_ON)
    clip(alpha - 0.5);
#endif
    SHADOW_CASTER_FRAGMENT(i)
}
#endif
