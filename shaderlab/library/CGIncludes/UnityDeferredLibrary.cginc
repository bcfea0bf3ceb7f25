#pragma once
#ifndef UNITY_DEFERRED_LIBRARY_INCLUDED
#define UNITY_DEFERRED_LIBRARY_INCLUDED
#include "UnityShadowLibrary.cginc"

UNITY_DECLARE_DEPTH_TEXTURE(_CameraDepthTexture);

cbuffer limn_DeferredLight
{
    float4 _LightDir;
    float4 _LightPos; // w: 1 / range^2
    float4 _LightColor;
    float _LightAsQuad; // 1: drawn as a rectangle over the screen
    float4x4 unity_WorldToLight;
};

#ifdef POINT_COOKIE
samplerCUBE_float _LightTexture0; // cookie
#else
sampler2D_float _LightTexture0;
#endif
sampler2D_float _LightTextureB0; // falloff over squared distance

struct unity_v2f_deferred
{
    float4 pos : SV_POSITION;
    float4 uv : TEXCOORD0;
    float3 ray : TEXCOORD1; // in view space, z forward
};

struct unity_v2f_deferred_instanced
{
    float4 pos : SV_POSITION;
    float4 uv : TEXCOORD0;
    float3 ray : TEXCOORD1;
    UNITY_VERTEX_OUTPUT_STEREO
};

unity_v2f_deferred vert_deferred(float4 vertex : POSITION, float3 normal : NORMAL)
{
    // A rectangle carries the corners of the far plane as its normals.
    float3 toSurface = UnityObjectToViewPos(vertex) * float3(-1, -1, 1);
    float4 clipPos = UnityObjectToClipPos(vertex);
    unity_v2f_deferred o;
    o.ray = lerp(toSurface, normal, _LightAsQuad);
    o.uv = ComputeScreenPos(clipPos);
    o.pos = clipPos;
    return o;
}

// There are no shadow maps.
half UnityDeferredComputeShadow(float3 vec, float fadeDist, float2 uv) { return 1.0; }

// What reaches a place of the light that the keyword names, and from where.
float limn_DeferredFalloff(float3 toLight)
{
    return tex2D(_LightTextureB0, (dot(toLight, toLight) * _LightPos.w).rr).UNITY_ATTEN_CHANNEL;
}
void limn_DeferredLightAt(float3 worldPos, out half3 lightDir, out float atten)
{
    lightDir = half3(0, 0, 0);
    atten = 0.0;
#if defined(SPOT) || defined(POINT) || defined(POINT_COOKIE)
    float3 toLight = _LightPos.xyz - worldPos;
    lightDir = normalize(toLight);
    atten = limn_DeferredFalloff(toLight);
#elif defined(DIRECTIONAL) || defined(DIRECTIONAL_COOKIE)
    lightDir = -_LightDir.xyz;
    atten = 1.0;
#endif
#if defined(SPOT) || defined(POINT_COOKIE) || defined(DIRECTIONAL_COOKIE)
    float4 inLight = mul(unity_WorldToLight, float4(worldPos, 1));
#endif
#if defined(SPOT)
    float cookie = tex2Dbias(_LightTexture0, float4(inLight.xy / inLight.w, 0, -8)).w;
    atten *= inLight.w < 0.0 ? cookie : 0.0; // its projection looks along -z
#elif defined(POINT_COOKIE)
    atten *= texCUBEbias(_LightTexture0, float4(inLight.xyz, -8)).w;
#elif defined(DIRECTIONAL_COOKIE)
    atten *= tex2Dbias(_LightTexture0, float4(inLight.xy, 0, -8)).w;
#endif
}

void UnityDeferredCalculateLightParams(unity_v2f_deferred i, out float3 outWorldPos,
                                       out float2 outUV, out half3 outLightDir,
                                       out float outAtten, out float outFadeDist)
{
    outUV = i.uv.xy / i.uv.w;
    float depth = Linear01Depth(SAMPLE_DEPTH_TEXTURE(_CameraDepthTexture, outUV));
    float4 viewPos = float4(i.ray * (_ProjectionParams.z / i.ray.z) * depth, 1);
    outWorldPos = mul(unity_CameraToWorld, viewPos).xyz;
    outFadeDist = UnityComputeShadowFadeDistance(outWorldPos, viewPos.z);
    limn_DeferredLightAt(outWorldPos, outLightDir, outAtten);
    outAtten *= UnityDeferredComputeShadow(outWorldPos, outFadeDist, outUV);
}
#endif
