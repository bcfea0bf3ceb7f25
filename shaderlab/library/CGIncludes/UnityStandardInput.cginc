// Properties and textures of the Standard shader, for shaders that vary it.
#pragma once
#ifndef UNITY_STANDARD_INPUT_INCLUDED
#define UNITY_STANDARD_INPUT_INCLUDED
#include "UnityCG.cginc"
#include "UnityStandardConfig.cginc"
#include "UnityPBSLighting.cginc"
#include "UnityStandardUtils.cginc"

half4 _Color;
half _Cutoff;
sampler2D _MainTex;
float4 _MainTex_ST;
sampler2D _DetailAlbedoMap;
float4 _DetailAlbedoMap_ST;
sampler2D _BumpMap;
half _BumpScale;
sampler2D _DetailMask;
sampler2D _DetailNormalMap;
half _DetailNormalMapScale;
sampler2D _SpecGlossMap;
sampler2D _MetallicGlossMap;
half _Metallic;
float _Glossiness;
float _GlossMapScale;
sampler2D _OcclusionMap;
half _OcclusionStrength;
sampler2D _ParallaxMap;
half _Parallax;
half _UVSec;
half4 _EmissionColor;
sampler2D _EmissionMap;

#if defined(_NORMALMAP) || defined(_PARALLAXMAP)
#define _TANGENT_TO_WORLD 1
#endif
#if defined(_DETAIL_MULX2) || defined(_DETAIL_MUL) || defined(_DETAIL_ADD) || defined(_DETAIL_LERP)
#define _DETAIL 1
#endif

struct VertexInput
{
    float4 vertex : POSITION;
    half3 normal : NORMAL;
    float2 uv0 : TEXCOORD0;
    float2 uv1 : TEXCOORD1;
#if defined(DYNAMICLIGHTMAP_ON) || defined(UNITY_PASS_META)
    float2 uv2 : TEXCOORD2;
#endif
#ifdef _TANGENT_TO_WORLD
    half4 tangent : TANGENT;
#endif
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

float4 TexCoords(VertexInput v)
{
    return float4(TRANSFORM_TEX(v.uv0, _MainTex),
                  TRANSFORM_TEX((_UVSec == 0 ? v.uv0 : v.uv1), _DetailAlbedoMap));
}

half DetailMask(float2 uv) { return tex2D(_DetailMask, uv).a; }

half3 Albedo(float4 texcoords)
{
    half3 albedo = _Color.rgb * tex2D(_MainTex, texcoords.xy).rgb;
#ifdef _DETAIL
    half mask = DetailMask(texcoords.xy);
    half3 detail = tex2D(_DetailAlbedoMap, texcoords.zw).rgb;
#if defined(_DETAIL_MUL)
    albedo *= LerpWhiteTo(detail, mask);
#elif defined(_DETAIL_ADD)
    albedo += detail * mask;
#elif defined(_DETAIL_LERP)
    albedo = lerp(albedo, detail, mask);
#else
    albedo *= LerpWhiteTo(detail * unity_ColorSpaceDouble.rgb, mask);
#endif
#endif
    return albedo;
}

half Alpha(float2 uv)
{
#if defined(_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A)
    return _Color.a;
#else
    return tex2D(_MainTex, uv).a * _Color.a;
#endif
}

half Occlusion(float2 uv) { return LerpOneTo(tex2D(_OcclusionMap, uv).g, _OcclusionStrength); }

half4 SpecularGloss(float2 uv)
{
#ifdef _SPECGLOSSMAP
    half4 sg = tex2D(_SpecGlossMap, uv);
#if defined(_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A)
    sg.a = tex2D(_MainTex, uv).a;
#endif
    return half4(sg.rgb, sg.a * _GlossMapScale);
#elif defined(_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A)
    return half4(_SpecColor.rgb, tex2D(_MainTex, uv).a * _GlossMapScale);
#else
    return half4(_SpecColor.rgb, _Glossiness);
#endif
}

half2 MetallicGloss(float2 uv)
{
#ifdef _METALLICGLOSSMAP
    half2 mg = tex2D(_MetallicGlossMap, uv).ra;
#if defined(_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A)
    mg.g = tex2D(_MainTex, uv).a;
#endif
    return half2(mg.r, mg.g * _GlossMapScale);
#elif defined(_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A)
    return half2(_Metallic, tex2D(_MainTex, uv).a * _GlossMapScale);
#else
    return half2(_Metallic, _Glossiness);
#endif
}
half2 MetallicRough(float2 uv)
{
#ifdef _METALLICGLOSSMAP
    half metallic = tex2D(_MetallicGlossMap, uv).r;
#else
    half metallic = _Metallic;
#endif
#ifdef _SPECGLOSSMAP
    return half2(metallic, 1.0 - tex2D(_SpecGlossMap, uv).r);
#else
    return half2(metallic, 1.0 - _Glossiness);
#endif
}

half3 Emission(float2 uv)
{
#ifdef _EMISSION
    return tex2D(_EmissionMap, uv).rgb * _EmissionColor.rgb;
#else
    return half3(0, 0, 0);
#endif
}

#ifdef _NORMALMAP
half3 NormalInTangentSpace(float4 texcoords)
{
    half3 normal = UnpackScaleNormal(tex2D(_BumpMap, texcoords.xy), _BumpScale);
#ifdef _DETAIL
    half3 detail =
        UnpackScaleNormal(tex2D(_DetailNormalMap, texcoords.zw), _DetailNormalMapScale);
    normal = lerp(normal, BlendNormals(normal, detail), DetailMask(texcoords.xy));
#endif
    return normal;
}
#endif

float4 Parallax(float4 texcoords, half3 viewDir)
{
#if defined(_PARALLAXMAP)
    half height = tex2D(_ParallaxMap, texcoords.xy).g;
    return texcoords + ParallaxOffset(height, _Parallax, viewDir).xyxy;
#else
    return texcoords;
#endif
}
#endif
