// SpeedTree 8 in the built-in pipeline: vertices, surfaces and the light that shines through leaves.
#pragma once
#ifndef SPEEDTREE8_COMMON_INCLUDED
#define SPEEDTREE8_COMMON_INCLUDED
#include "UnityCG.cginc"
#include "UnityPBSLighting.cginc"
#define SPEEDTREE_Y_UP
#include "limn/SpeedTree8Vertex.hlsl"
#include "limn/SpeedTreeHue.hlsl"

struct Input
{
    half2 uv_MainTex : TEXCOORD0;
    fixed4 color : COLOR; // r: ambient occlusion, g: how far the hue varies, a: of a billboard
#ifdef EFFECT_BACKSIDE_NORMALS
    fixed facing : VFACE;
#endif
};

sampler2D _MainTex;
fixed4 _Color;
int _TwoSided;
#ifdef EFFECT_BUMP
sampler2D _BumpMap;
#endif
#ifdef EFFECT_EXTRA_TEX
sampler2D _ExtraTex; // smoothness, metallic, ambient occlusion
#else
half _Glossiness;
half _Metallic;
#endif
#ifdef EFFECT_HUE_VARIATION
half4 _HueVariationColor;
#endif
#ifdef EFFECT_BILLBOARD
half _BillboardShadowFade;
#endif
#ifdef EFFECT_SUBSURFACE
sampler2D _SubsurfaceTex;
fixed4 _SubsurfaceColor;
half _SubsurfaceIndirect;
#endif

void OffsetSpeedTreeVertex(inout appdata_full data, float lodValue)
{
    float3 position = data.vertex.xyz;
#if defined(LOD_FADE_PERCENTAGE) && !defined(EFFECT_BILLBOARD)
    position = lerp(position, data.texcoord2.xyz, lodValue);
#endif
#ifdef limn_SPEEDTREE8_WIND
    position = limn_BlowSpeedTree8(data.texcoord, data.texcoord1, data.texcoord2, data.texcoord3,
                                   position, data.normal);
#endif
    data.vertex.xyz = position;
}

void SpeedTreeVert(inout appdata_full v)
{
    OffsetSpeedTreeVertex(v, unity_LODFade.x);
#ifdef EFFECT_BILLBOARD
    float3 toCamera = _WorldSpaceCameraPos - UNITY_MATRIX_M._14_24_34;
    limn_FadeBillboard8(normalize(mul((float3x3)unity_WorldToObject, toCamera)),
                        v.texcoord.z > 0.5, v.tangent, v.vertex.xyz, v.normal, v.color);
#endif
#ifdef EFFECT_HUE_VARIATION
    v.color.g = saturate(limn_HueOfTree() * _HueVariationColor.a);
#endif
}

half4 LightingSpeedTreeSubsurface(inout SurfaceOutputStandard s, half3 viewDir, UnityGI gi)
{
#ifdef EFFECT_SUBSURFACE
    half through = GGXTerm(saturate(-dot(gi.light.dir, viewDir)), 0.7 - s.Smoothness * 0.5);
    s.Emission *= gi.light.color * through + gi.indirect.diffuse * _SubsurfaceIndirect;
#endif
    return LightingStandard(s, viewDir, gi);
}
void LightingSpeedTreeSubsurface_GI(inout SurfaceOutputStandard s, UnityGIInput data,
                                    inout UnityGI gi)
{
#ifdef EFFECT_BILLBOARD
    data.atten += (1.0 - data.atten) * _BillboardShadowFade; // far away there is no shadow
#endif
    LightingStandard_GI(s, data, gi);
}
half4 LightingSpeedTreeSubsurface_Deferred(SurfaceOutputStandard s, half3 viewDir, UnityGI gi,
                                           out half4 outGBuffer0, out half4 outGBuffer1,
                                           out half4 outGBuffer2)
{
    s.Emission = 0; // what shines through needs the light
    return LightingStandard_Deferred(s, viewDir, gi, outGBuffer0, outGBuffer1, outGBuffer2);
}

half3 limn_SpeedTree8Normal(Input IN, half3 normal)
{
#ifdef EFFECT_BUMP
    normal = UnpackNormal(tex2D(_BumpMap, IN.uv_MainTex));
#elif defined(EFFECT_BACKSIDE_NORMALS) || defined(EFFECT_BILLBOARD)
    normal = half3(0, 0, 1);
#endif
#ifdef EFFECT_BACKSIDE_NORMALS
    normal.z *= IN.facing < 0.5 ? -1.0 : 1.0;
#endif
#ifdef EFFECT_BILLBOARD
    normal = normalize(normal * half3(1, 1, 0.5));
#endif
    return normal;
}

void SpeedTreeSurf(Input IN, inout SurfaceOutputStandard OUT)
{
    fixed4 color = _Color * tex2D(_MainTex, IN.uv_MainTex);
    OUT.Alpha = IN.color.a * color.a;
    clip(OUT.Alpha - 0.3333);
#ifdef EFFECT_HUE_VARIATION
    color.rgb = limn_VaryHue(color.rgb, _HueVariationColor.rgb, IN.color.g);
#endif
    OUT.Albedo = color.rgb;
    OUT.Normal = limn_SpeedTree8Normal(IN, OUT.Normal);
#ifdef EFFECT_SUBSURFACE
    OUT.Emission = _SubsurfaceColor.rgb * tex2D(_SubsurfaceTex, IN.uv_MainTex).rgb;
#endif
#ifndef EFFECT_EXTRA_TEX
    OUT.Occlusion = IN.color.r;
    OUT.Metallic = _Metallic;
    OUT.Smoothness = _Glossiness;
#else
    half3 maps = tex2D(_ExtraTex, IN.uv_MainTex).rgb;
    OUT.Occlusion = maps.z * IN.color.r;
    OUT.Metallic = maps.y;
    OUT.Smoothness = maps.x;
#endif
}
#endif
