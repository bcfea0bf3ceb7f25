// Terrains: up to four layers a pass, mixed by the channels of _Control. limn draws terrains as
// meshes: nothing is instanced out of height maps.
#pragma once
#ifndef TERRAIN_SPLATMAP_COMMON_CGINC_INCLUDED
#define TERRAIN_SPLATMAP_COMMON_CGINC_INCLUDED
#ifdef _NORMALMAP
#define _TERRAIN_NORMAL_MAP // as it was called before Unity 2018.3
#endif
#include "UnityCG.cginc"
#include "UnityGBuffer.cginc"
#include "Lighting.cginc"

struct Input
{
    float4 tc; // xy: over the terrain
#ifndef TERRAIN_BASE_PASS
    UNITY_FOG_COORDS(0)
#endif
};

sampler2D _Control;
float4 _Control_ST;
float4 _Control_TexelSize;
sampler2D _Splat0, _Splat1, _Splat2, _Splat3;
float4 _Splat0_ST, _Splat1_ST, _Splat2_ST, _Splat3_ST;
#ifdef _NORMALMAP
sampler2D _Normal0, _Normal1, _Normal2, _Normal3;
float _NormalScale0, _NormalScale1, _NormalScale2, _NormalScale3;
#endif
#if defined(TERRAIN_BASE_PASS) && defined(UNITY_PASS_META)
float4 _MainTex_ST;
#endif

#ifdef _ALPHATEST_ON
sampler2D _TerrainHolesTexture;
void ClipHoles(float2 uv) { clip(tex2D(_TerrainHolesTexture, uv).r == 0.0 ? -1.0 : 1.0); }
#endif

void SplatmapVert(inout appdata_full v, out Input data)
{
    UNITY_INITIALIZE_OUTPUT(Input, data);
    v.tangent = float4(cross(v.normal, float3(0, 0, 1)), -1.0);
    data.tc.xy = v.texcoord.xy;
#if !defined(TERRAIN_BASE_PASS)
    float4 pos = UnityObjectToClipPos(v.vertex);
    UNITY_TRANSFER_FOG(data, pos);
#elif defined(UNITY_PASS_META)
    data.tc.xy = TRANSFORM_TEX(v.texcoord, _MainTex);
#endif
}

#ifndef TERRAIN_BASE_PASS
// defaultAlpha: the smoothness of each layer.
void limn_SplatmapMix(Input IN, half4 defaultAlpha, out half4 splat_control, out half weight,
                      out fixed4 mixedDiffuse, inout fixed3 mixedNormal)
{
#ifdef _ALPHATEST_ON
    ClipHoles(IN.tc.xy);
#endif
    // The edges of the terrain lie on centres of texels.
    float2 controlUV = (IN.tc.xy * (_Control_TexelSize.zw - 1.0) + 0.5) * _Control_TexelSize.xy;
    half4 density = tex2D(_Control, controlUV);
    weight = density.r + density.g + density.b + density.a;
#ifdef TERRAIN_SPLAT_ADDPASS
    clip(weight == 0.0 ? -1.0 : 1.0);
#endif
    splat_control = density / (weight + 0.001);

    float2 uv0 = TRANSFORM_TEX(IN.tc.xy, _Splat0);
    float2 uv1 = TRANSFORM_TEX(IN.tc.xy, _Splat1);
    float2 uv2 = TRANSFORM_TEX(IN.tc.xy, _Splat2);
    float2 uv3 = TRANSFORM_TEX(IN.tc.xy, _Splat3);
    mixedDiffuse = splat_control.r * tex2D(_Splat0, uv0) * half4(1, 1, 1, defaultAlpha.r) +
                   splat_control.g * tex2D(_Splat1, uv1) * half4(1, 1, 1, defaultAlpha.g) +
                   splat_control.b * tex2D(_Splat2, uv2) * half4(1, 1, 1, defaultAlpha.b) +
                   splat_control.a * tex2D(_Splat3, uv3) * half4(1, 1, 1, defaultAlpha.a);
#ifdef _NORMALMAP
    mixedNormal = UnpackNormalWithScale(tex2D(_Normal0, uv0), _NormalScale0) * splat_control.r +
                  UnpackNormalWithScale(tex2D(_Normal1, uv1), _NormalScale1) * splat_control.g +
                  UnpackNormalWithScale(tex2D(_Normal2, uv2), _NormalScale2) * splat_control.b +
                  UnpackNormalWithScale(tex2D(_Normal3, uv3), _NormalScale3) * splat_control.a;
    mixedNormal.z += 1e-5; // may be normalised where no layer is
#endif
}
#ifdef TERRAIN_STANDARD_SHADER
void SplatmapMix(Input IN, half4 defaultAlpha, out half4 splat_control, out half weight,
                 out fixed4 mixedDiffuse, inout fixed3 mixedNormal)
{
    limn_SplatmapMix(IN, defaultAlpha, splat_control, weight, mixedDiffuse, mixedNormal);
}
#else
void SplatmapMix(Input IN, out half4 splat_control, out half weight, out fixed4 mixedDiffuse,
                 inout fixed3 mixedNormal)
{
    limn_SplatmapMix(IN, half4(1, 1, 1, 1), splat_control, weight, mixedDiffuse, mixedNormal);
}
#endif

#ifndef TERRAIN_SURFACE_OUTPUT
#define TERRAIN_SURFACE_OUTPUT SurfaceOutput
#endif
// Alpha is the weight of the pass's layers: passes add up.
void SplatmapFinalColor(Input IN, TERRAIN_SURFACE_OUTPUT o, inout fixed4 color)
{
    fixed4 weighted = color * o.Alpha;
#ifndef TERRAIN_SPLAT_ADDPASS
    UNITY_APPLY_FOG(IN.fogCoord, weighted);
#else
    // The first pass has brought the fog's own light.
    UNITY_APPLY_FOG_COLOR(IN.fogCoord, weighted, fixed4(0, 0, 0, 0));
#endif
    color = weighted;
}
void SplatmapFinalPrepass(Input IN, TERRAIN_SURFACE_OUTPUT o, inout fixed4 normalSpec)
{
    normalSpec *= o.Alpha;
}
void SplatmapFinalGBuffer(Input IN, TERRAIN_SURFACE_OUTPUT o, inout half4 outGBuffer0,
                          inout half4 outGBuffer1, inout half4 outGBuffer2, inout half4 emission)
{
    UnityStandardDataApplyWeightToGbuffer(outGBuffer0, outGBuffer1, outGBuffer2, o.Alpha);
    emission *= o.Alpha;
}
#endif
#endif
