// Surfaces of SpeedTree 6 and 7 for surface functions and passes of the author's.
#pragma once
#ifndef SPEEDTREE_COMMON_INCLUDED
#define SPEEDTREE_COMMON_INCLUDED
#include "UnityCG.cginc"
#define SPEEDTREE_Y_UP

#ifdef GEOM_TYPE_BRANCH_DETAIL
#define GEOM_TYPE_BRANCH
#endif
#if defined(GEOM_TYPE_FROND) || defined(GEOM_TYPE_LEAF) || defined(GEOM_TYPE_FACING_LEAF)
#define SPEEDTREE_ALPHATEST
fixed _Cutoff;
#endif
#if defined(EFFECT_BUMP) && !defined(LIGHTMAP_ON)
#define limn_SPEEDTREE_BUMP 1
#endif
#include "SpeedTreeVertex.cginc"
#include "limn/SpeedTreeHue.hlsl"

struct Input
{
    fixed4 color;
    half3 interpolator1; // uv of the main texture, how far the hue varies
#ifdef GEOM_TYPE_BRANCH_DETAIL
    half3 interpolator2; // uv of the detail, how much of it; above 2: as its alpha says
#endif
};
#define mainTexUV interpolator1.xy

sampler2D _MainTex;
fixed4 _Color;
#ifdef GEOM_TYPE_BRANCH_DETAIL
#define Detail interpolator2
sampler2D _DetailTex;
#endif
#ifdef EFFECT_HUE_VARIATION
#define HueVariationAmount interpolator1.z
half4 _HueVariation;
#endif
#ifdef limn_SPEEDTREE_BUMP
sampler2D _BumpMap;
#define SPEEDTREE_DATA_NORMAL fixed3 Normal;
#define SPEEDTREE_COPY_NORMAL(to, from) to.Normal = from.Normal;
#else
#define SPEEDTREE_DATA_NORMAL
#define SPEEDTREE_COPY_NORMAL(to, from)
#endif
#define SPEEDTREE_COPY_FRAG(to, from)                                                              \
    to.Albedo = from.Albedo;                                                                       \
    to.Alpha = from.Alpha;                                                                         \
    SPEEDTREE_COPY_NORMAL(to, from)

void SpeedTreeVert(inout SpeedTreeVB IN, out Input OUT)
{
    UNITY_INITIALIZE_OUTPUT(Input, OUT);
    OUT.mainTexUV = IN.texcoord.xy;
    OUT.color = fixed4(_Color.rgb * IN.color.r, _Color.a); // r: ambient occlusion
#ifdef EFFECT_HUE_VARIATION
    // Trees differ by where they stand, and their parts by where these lie and look.
    float ofTree = frac(dot(unity_ObjectToWorld._14_24_34, 1.0));
    float ofPart = frac(IN.normal.x + (IN.normal.y + IN.vertex.x));
    OUT.HueVariationAmount = saturate((ofTree + (0.5 * ofPart - 0.3)) * _HueVariation.a);
#endif
#ifdef GEOM_TYPE_BRANCH_DETAIL
    OUT.Detail = half3(IN.texcoord2.xy, IN.color.a == 0 ? IN.texcoord2.z : 2.5);
#endif
    OffsetSpeedTreeVertex(IN, unity_LODFade.x);
}

struct SpeedTreeFragOut
{
    fixed3 Albedo;
    fixed Alpha;
    SPEEDTREE_DATA_NORMAL
};

void SpeedTreeFrag(Input IN, out SpeedTreeFragOut OUT)
{
    UNITY_INITIALIZE_OUTPUT(SpeedTreeFragOut, OUT);
    half4 diffuse = tex2D(_MainTex, IN.mainTexUV);
    OUT.Alpha = diffuse.a * _Color.a;
#ifdef SPEEDTREE_ALPHATEST
    clip(OUT.Alpha - _Cutoff);
#endif
#ifdef GEOM_TYPE_BRANCH_DETAIL
    half4 detail = tex2D(_DetailTex, IN.Detail.xy);
    half share = IN.Detail.z < 2.0 ? saturate(IN.Detail.z) : detail.a;
    diffuse.rgb = lerp(diffuse.rgb, detail.rgb, share);
#endif
#ifdef EFFECT_HUE_VARIATION
    diffuse.rgb = limn_VaryHue(diffuse.rgb, _HueVariation.rgb, IN.HueVariationAmount);
#endif
    OUT.Albedo = diffuse.rgb * IN.color.rgb;
#ifdef limn_SPEEDTREE_BUMP
    OUT.Normal = UnpackNormal(tex2D(_BumpMap, IN.mainTexUV));
#ifdef GEOM_TYPE_BRANCH_DETAIL
    OUT.Normal = lerp(OUT.Normal, UnpackNormal(tex2D(_BumpMap, IN.Detail.xy)), share);
#endif
#endif
}
#endif
