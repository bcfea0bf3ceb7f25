// Passes with LightMode ShadowCaster: depth alone, or (SHADOWS_CUBE) the distance to a point light.
#pragma once

// Moves towards the light are away from it in depth: bias along the light, at most up to its near
// plane. unity_LightShadowBias: depth, 1 for directional lights, along the normal.
float4 UnityApplyLinearShadowBias(float4 clipPos)
{
#if !defined(SHADOWS_CUBE) || defined(SHADOWS_CUBE_IN_DEPTH_TEX)
    float nearest = UNITY_NEAR_CLIP_VALUE * clipPos.w;
    float bias = unity_LightShadowBias.x / clipPos.w;
#if defined(UNITY_REVERSED_Z)
    float moved = clipPos.z + clamp(bias, -1.0, 0.0);
    float kept = min(moved, nearest);
#else
    float moved = clipPos.z + saturate(bias);
    float kept = max(moved, nearest);
#endif
    clipPos.z = lerp(moved, kept, unity_LightShadowBias.y);
#endif
    return clipPos;
}

// The surface pulled in along its normal, the more the flatter the light falls on it.
float4 UnityClipSpaceShadowCasterPos(float4 vertex, float3 normal)
{
    float4 worldPos = mul(unity_ObjectToWorld, vertex);
    if (unity_LightShadowBias.z != 0.0)
    {
        float3 worldNormal = UnityObjectToWorldNormal(normal);
        float cosine = dot(worldNormal, normalize(UnityWorldSpaceLightDir(worldPos.xyz)));
        float sine = sqrt(max(0.0, 1.0 - cosine * cosine));
        worldPos.xyz -= worldNormal * (unity_LightShadowBias.z * sine);
    }
    return mul(UNITY_MATRIX_VP, worldPos);
}
float4 UnityClipSpaceShadowCasterPos(float3 vertex, float3 normal)
{
    return UnityClipSpaceShadowCasterPos(float4(vertex, 1.0), normal);
}

float4 UnityEncodeCubeShadowDepth(float z) { return float4(z, z, z, z); }
float UnityDecodeCubeShadowDepth(float4 vals) { return vals.r; }

#if defined(SHADOWS_CUBE) && !defined(SHADOWS_CUBE_IN_DEPTH_TEX)
#define V2F_SHADOW_CASTER_NOPOS float3 vec : TEXCOORD0;
#define TRANSFER_SHADOW_CASTER_NOPOS_LEGACY(o, opos) \
    o.vec = mul(unity_ObjectToWorld, v.vertex).xyz - _LightPositionRange.xyz; \
    opos = UnityObjectToClipPos(v.vertex);
#define TRANSFER_SHADOW_CASTER_NOPOS(o, opos) TRANSFER_SHADOW_CASTER_NOPOS_LEGACY(o, opos)
#define SHADOW_CASTER_FRAGMENT(i) \
    return UnityEncodeCubeShadowDepth((length(i.vec) + unity_LightShadowBias.x) * \
                                      _LightPositionRange.w);
#else
#define V2F_SHADOW_CASTER_NOPOS
#define TRANSFER_SHADOW_CASTER_NOPOS_LEGACY(o, opos) \
    opos = UnityObjectToClipPos(v.vertex.xyz); \
    opos = UnityApplyLinearShadowBias(opos);
#define TRANSFER_SHADOW_CASTER_NOPOS(o, opos) \
    opos = UnityClipSpaceShadowCasterPos(v.vertex, v.normal); \
    opos = UnityApplyLinearShadowBias(opos);
#define SHADOW_CASTER_FRAGMENT(i) return 0;
#endif

#define V2F_SHADOW_CASTER V2F_SHADOW_CASTER_NOPOS UNITY_POSITION(pos)
#define TRANSFER_SHADOW_CASTER(o) TRANSFER_SHADOW_CASTER_NOPOS_LEGACY(o, o.pos)
#define TRANSFER_SHADOW_CASTER_NORMALOFFSET(o) TRANSFER_SHADOW_CASTER_NOPOS(o, o.pos)
