// Passes of SpeedTree 7 and of its billboards: all but where the vertices are.
#pragma once
#ifndef UNIVERSAL_SPEEDTREE7COMMON_PASSES_INCLUDED
#define UNIVERSAL_SPEEDTREE7COMMON_PASSES_INCLUDED
#include "limn/SpeedTreePass.hlsl"
#include "SpeedTreeUtility.hlsl"

// texcoord and the others: as SpeedTreeVB of SpeedTreeVertex.cginc has them.
struct SpeedTreeVertexInput
{
    float4 vertex : POSITION;
    float3 normal : NORMAL;
    float4 tangent : TANGENT;
    float4 texcoord : TEXCOORD0;
    float4 texcoord1 : TEXCOORD1;
    float4 texcoord2 : TEXCOORD2;
    float2 texcoord3 : TEXCOORD3;
    half4 color : COLOR;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

#ifdef GEOM_TYPE_BRANCH_DETAIL
#define limn_TREE_DETAIL half3 detail : TEXCOORD1; // uv, how much; above 2: as its alpha says
#else
#define limn_TREE_DETAIL
#endif

struct SpeedTreeVertexOutput
{
#ifdef VERTEX_COLOR
    half4 color : COLOR;
#endif
    half3 uvHueVariation : TEXCOORD0;
    limn_TREE_DETAIL
    limn_TREE_LIT
};
struct SpeedTreeVertexDepthOutput
{
    half3 uvHueVariation : TEXCOORD0;
    limn_TREE_DEPTH
};
struct SpeedTreeVertexDepthNormalOutput
{
    half3 uvHueVariation : TEXCOORD0;
    limn_TREE_DETAIL
    limn_TREE_DEPTH_NORMAL
};

void InitializeInputData(SpeedTreeVertexOutput input, half3 normalTS, out InputData inputData)
{
    limn_TREE_INPUT(input, normalTS, inputData)
}

half limn_Tree7Alpha(half alpha)
{
    alpha *= _Color.a;
#ifdef SPEEDTREE_ALPHATEST
    alpha = AlphaDiscard(alpha, _Cutoff);
#endif
    return alpha;
}
half4 limn_Tree7Diffuse(half2 uv)
{
    half4 diffuse = SampleAlbedoAlpha(uv, TEXTURE2D_ARGS(_MainTex, sampler_MainTex));
    return half4(diffuse.rgb, limn_Tree7Alpha(diffuse.a));
}

// The detail's colour over the other, and its normal by the same share.
void limn_Tree7AddDetail(half3 detail, inout half3 color, inout half3 normalTS)
{
#ifdef GEOM_TYPE_BRANCH_DETAIL
    half4 texel = tex2D(_DetailTex, detail.xy);
    half share = detail.z < 2.0 ? saturate(detail.z) : texel.a;
    color = lerp(color, texel.rgb, share);
#ifdef EFFECT_BUMP
    half3 bump = SampleNormal(detail.xy, TEXTURE2D_ARGS(_BumpMap, sampler_BumpMap));
    normalTS = lerp(normalTS, bump, share);
#endif
#endif
}
half3 limn_Tree7Normal(half2 uv)
{
    return SampleNormal(uv, TEXTURE2D_ARGS(_BumpMap, sampler_BumpMap));
}

SurfaceData limn_Tree7Surface(SpeedTreeVertexOutput input)
{
    half4 diffuse = limn_Tree7Diffuse(input.uvHueVariation.xy);
    SurfaceData surface = (SurfaceData)0;
    surface.albedo = diffuse.rgb;
    surface.alpha = diffuse.a;
    surface.occlusion = 1.0;
    surface.clearCoatSmoothness = 1.0;
    surface.normalTS = limn_Tree7Normal(input.uvHueVariation.xy);
#ifdef GEOM_TYPE_BRANCH_DETAIL
    limn_Tree7AddDetail(input.detail, surface.albedo, surface.normalTS);
#endif
#ifdef EFFECT_HUE_VARIATION
    surface.albedo = limn_VaryHue(surface.albedo, _HueVariation.rgb, input.uvHueVariation.z);
#endif
#ifdef VERTEX_COLOR
    surface.albedo *= input.color.rgb;
#else
    surface.albedo *= _Color.rgb;
#endif
    return surface;
}

#ifdef GBUFFER
FragmentOutput SpeedTree7Frag(SpeedTreeVertexOutput input)
#else
half4 SpeedTree7Frag(SpeedTreeVertexOutput input) : SV_Target
#endif
{
    SurfaceData surface = limn_Tree7Surface(input);
    LODFadeCrossFade(input.clipPos);
    InputData data;
    InitializeInputData(input, surface.normalTS, data);
#ifdef GBUFFER
    return SurfaceDataToGbuffer(surface, data, data.bakedGI * surface.albedo, kLightingSimpleLit);
#else
    half4 color = UniversalFragmentBlinnPhong(data, surface);
    return half4(MixFog(color.rgb, data.fogCoord), OutputAlpha(color.a, _Surface));
#endif
}

half4 SpeedTree7FragDepth(SpeedTreeVertexDepthOutput input) : SV_Target
{
    limn_Tree7Diffuse(input.uvHueVariation.xy);
    return limn_TreeDepth(input.clipPos);
}

half4 SpeedTree7FragDepthNormal(SpeedTreeVertexDepthNormalOutput input) : SV_Target
{
    half3 color = limn_Tree7Diffuse(input.uvHueVariation.xy).rgb;
    LODFadeCrossFade(input.clipPos);
    half3 normalTS = limn_Tree7Normal(input.uvHueVariation.xy);
#ifdef GEOM_TYPE_BRANCH_DETAIL
    limn_Tree7AddDetail(input.detail, color, normalTS);
#endif
    return half4(limn_TreeNormal(normalTS, input.normalWS, input.tangentWS), 0.0);
}
#endif
