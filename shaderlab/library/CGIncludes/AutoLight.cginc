// What arrives of the light of a pass. The main light is directional and throws no shadows; POINT,
// SPOT and the cookie keywords read the textures that Unity names for them.
#pragma once
#ifndef AUTOLIGHT_INCLUDED
#define AUTOLIGHT_INCLUDED
#include "HLSLSupport.cginc"
#include "UnityShadowLibrary.cginc"

// Shadows
#if defined(SHADOWS_SCREEN) || defined(SHADOWS_DEPTH) && defined(SPOT)
#define SHADOW_COORDS(index) unityShadowCoord4 _ShadowCoord : TEXCOORD##index;
#define TRANSFER_SHADOW(a) a._ShadowCoord = ComputeScreenPos(a.pos);
#elif defined(SHADOWS_CUBE)
#define SHADOW_COORDS(index) unityShadowCoord3 _ShadowCoord : TEXCOORD##index;
#define TRANSFER_SHADOW(a) a._ShadowCoord = mul(unity_ObjectToWorld, v.vertex).xyz;
#else
#define SHADOW_COORDS(index)
#define TRANSFER_SHADOW(a)
#endif
#if defined(SHADOWS_SCREEN) || defined(SHADOWS_DEPTH) || defined(SHADOWS_CUBE)
[limn_Lacks("shadow maps", "everything is lit")]
fixed limn_Lit() { return 1.0; }
#define SHADOW_ATTENUATION(a) limn_Lit()
#else
#define SHADOW_ATTENUATION(a) 1.0
#endif
fixed unitySampleShadow(unityShadowCoord4 shadowCoord) { return SHADOW_ATTENUATION(0); }
half UnityComputeForwardShadows(float2 lightmapUV, float3 worldPos, float4 screenPos) { return 1.0; }

#define UNITY_SHADOW_COORDS(index) SHADOW_COORDS(index)
#define UNITY_TRANSFER_SHADOW(a, coord) TRANSFER_SHADOW(a)
#define UNITY_SHADOW_ATTENUATION(a, worldPos) SHADOW_ATTENUATION(a)
#define UNITY_READ_SHADOW_COORDS(input) 0
#define TRANSFER_SHADOW_WPOS(a, wpos) TRANSFER_SHADOW(a)
#define SHADOWS_COORDS(index) SHADOW_COORDS(index)

// Falloff and cookie of the light
#if defined(POINT) || defined(SPOT) || defined(POINT_COOKIE) || defined(DIRECTIONAL_COOKIE)
#define _LightMatrix0 unity_WorldToLight // as Unity's upgrade of old shaders has it
cbuffer limn_LightOfPass
{
    unityShadowCoord4x4 unity_WorldToLight;
};
#define limn_LightCoord(worldPos) mul(unity_WorldToLight, unityShadowCoord4(worldPos, 1))
#endif

#if defined(POINT)
sampler2D_float _LightTexture0; // falloff over squared distance
fixed limn_LightFalloff(float3 worldPos)
{
    float3 coord = limn_LightCoord(worldPos).xyz;
    return tex2D(_LightTexture0, dot(coord, coord).rr).r;
}
#define DECLARE_LIGHT_COORDS(index) unityShadowCoord3 _LightCoord : TEXCOORD##index;
#define COMPUTE_LIGHT_COORDS(a) a._LightCoord = limn_LightCoord(mul(unity_ObjectToWorld, v.vertex).xyz).xyz;
#define limn_FalloffOf(a) (tex2D(_LightTexture0, dot(a._LightCoord, a._LightCoord).rr).r)
#elif defined(SPOT)
sampler2D_float _LightTexture0;  // cookie
sampler2D_float _LightTextureB0; // falloff over squared distance
fixed UnitySpotCookie(unityShadowCoord4 lightCoord)
{
    return tex2D(_LightTexture0, lightCoord.xy / lightCoord.w + 0.5).w;
}
fixed UnitySpotAttenuate(unityShadowCoord3 lightCoord)
{
    return tex2D(_LightTextureB0, dot(lightCoord, lightCoord).xx).r;
}
fixed limn_SpotFalloff(unityShadowCoord4 coord)
{
    return (coord.z > 0) * UnitySpotCookie(coord) * UnitySpotAttenuate(coord.xyz);
}
fixed limn_LightFalloff(float3 worldPos) { return limn_SpotFalloff(limn_LightCoord(worldPos)); }
#define DECLARE_LIGHT_COORDS(index) unityShadowCoord4 _LightCoord : TEXCOORD##index;
#define COMPUTE_LIGHT_COORDS(a) a._LightCoord = limn_LightCoord(mul(unity_ObjectToWorld, v.vertex).xyz);
#define limn_FalloffOf(a) limn_SpotFalloff(a._LightCoord)
#elif defined(POINT_COOKIE)
samplerCUBE_float _LightTexture0;
sampler2D_float _LightTextureB0;
fixed limn_PointCookie(unityShadowCoord3 coord)
{
    return tex2D(_LightTextureB0, dot(coord, coord).rr).r * texCUBE(_LightTexture0, coord).w;
}
fixed limn_LightFalloff(float3 worldPos) { return limn_PointCookie(limn_LightCoord(worldPos).xyz); }
#define DECLARE_LIGHT_COORDS(index) unityShadowCoord3 _LightCoord : TEXCOORD##index;
#define COMPUTE_LIGHT_COORDS(a) a._LightCoord = limn_LightCoord(mul(unity_ObjectToWorld, v.vertex).xyz).xyz;
#define limn_FalloffOf(a) limn_PointCookie(a._LightCoord)
#elif defined(DIRECTIONAL_COOKIE)
sampler2D_float _LightTexture0;
fixed limn_LightFalloff(float3 worldPos)
{
    return tex2D(_LightTexture0, limn_LightCoord(worldPos).xy).w;
}
#define DECLARE_LIGHT_COORDS(index) unityShadowCoord2 _LightCoord : TEXCOORD##index;
#define COMPUTE_LIGHT_COORDS(a) a._LightCoord = limn_LightCoord(mul(unity_ObjectToWorld, v.vertex).xyz).xy;
#define limn_FalloffOf(a) (tex2D(_LightTexture0, a._LightCoord).w)
#else
fixed limn_LightFalloff(float3 worldPos) { return 1.0; }
#define DECLARE_LIGHT_COORDS(index)
#define COMPUTE_LIGHT_COORDS(a)
#define limn_FalloffOf(a) 1.0
#endif

#define DECLARE_LIGHT_COORD(input, worldPos)
#define LIGHTING_COORDS(lightIndex, shadowIndex) \
    DECLARE_LIGHT_COORDS(lightIndex) SHADOW_COORDS(shadowIndex)
#define UNITY_LIGHTING_COORDS(lightIndex, shadowIndex) LIGHTING_COORDS(lightIndex, shadowIndex)
#define TRANSFER_VERTEX_TO_FRAGMENT(a) COMPUTE_LIGHT_COORDS(a) TRANSFER_SHADOW(a)
#define TRANSFER_LIGHTING(a) TRANSFER_VERTEX_TO_FRAGMENT(a)
#define UNITY_TRANSFER_LIGHTING(a, coord) TRANSFER_VERTEX_TO_FRAGMENT(a)
#define LIGHT_ATTENUATION(a) (limn_FalloffOf(a) * SHADOW_ATTENUATION(a))
// Declares destName.
#define UNITY_LIGHT_ATTENUATION(destName, input, worldPos) \
    fixed destName = limn_LightFalloff(worldPos) * UNITY_SHADOW_ATTENUATION(input, worldPos);
#endif
