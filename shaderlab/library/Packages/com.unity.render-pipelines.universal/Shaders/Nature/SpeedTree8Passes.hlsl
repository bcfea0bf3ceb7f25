// Passes of SpeedTree 8.
#pragma once
#ifndef UNIVERSAL_SPEEDTREE8_PASSES_INCLUDED
#define UNIVERSAL_SPEEDTREE8_PASSES_INCLUDED
#include "limn/SpeedTreePass.hlsl"
#include "SpeedTreeUtility.hlsl"

struct SpeedTreeVertexInput
{
    float4 vertex : POSITION;
    float3 normal : NORMAL;
    float4 tangent : TANGENT;
    float4 texcoord : TEXCOORD0;
    float4 texcoord1 : TEXCOORD1;
    float4 texcoord2 : TEXCOORD2;
    float4 texcoord3 : TEXCOORD3;
    float4 color : COLOR;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

// color: r: ambient occlusion, g: how far the hue varies, a: of a billboard
struct SpeedTreeVertexOutput
{
    half2 uv : TEXCOORD0;
    half4 color : TEXCOORD1;
    limn_TREE_LIT
};
struct SpeedTreeVertexDepthOutput
{
    half2 uv : TEXCOORD0;
    half4 color : TEXCOORD1;
    limn_TREE_DEPTH
};
struct SpeedTreeVertexDepthNormalOutput
{
    half2 uv : TEXCOORD0;
    half4 color : TEXCOORD1;
    limn_TREE_DEPTH_NORMAL
};

#ifdef EFFECT_BACKSIDE_NORMALS
#define limn_TREE_FACING FRONT_FACE_TYPE facing : FRONT_FACE_SEMANTIC;
#define limn_TREE_SIDE(input) IS_FRONT_VFACE(input.facing, 1.0, -1.0)
#else
#define limn_TREE_FACING
#define limn_TREE_SIDE(input) 1.0
#endif
struct SpeedTreeFragmentInput
{
    SpeedTreeVertexOutput interpolated;
    limn_TREE_FACING
};
struct SpeedTreeDepthNormalFragmentInput
{
    SpeedTreeVertexDepthNormalOutput interpolated;
    limn_TREE_FACING
};

void InitializeData(inout SpeedTreeVertexInput input, float lodValue)
{
    float3 position = input.vertex.xyz;
#if defined(LOD_FADE_PERCENTAGE) && !defined(LOD_FADE_CROSSFADE) && !defined(EFFECT_BILLBOARD)
    position = lerp(position, input.texcoord2.xyz, lodValue);
#endif
#ifdef limn_SPEEDTREE8_WIND
    position = limn_BlowSpeedTree8(input.texcoord, input.texcoord1, input.texcoord2,
                                   input.texcoord3, position, input.normal);
#endif
#ifdef EFFECT_BILLBOARD
    // Unlike the built-in pipeline, URP turns the direction by the object's matrix itself.
    float3 toCamera = _WorldSpaceCameraPos - UNITY_MATRIX_M._14_24_34;
    limn_FadeBillboard8(normalize(mul((float3x3)UNITY_MATRIX_M, toCamera)),
                        input.texcoord.z > 0.5, input.tangent, position, input.normal,
                        input.color);
#endif
    input.vertex.xyz = position;
}

SpeedTreeVertexOutput SpeedTree8Vert(SpeedTreeVertexInput input)
{
    UNITY_SETUP_INSTANCE_ID(input);
    InitializeData(input, unity_LODFade.x);
    SpeedTreeVertexOutput output = (SpeedTreeVertexOutput)0;
    output.color = input.color;
    output.uv = input.texcoord.xy;
#ifdef EFFECT_HUE_VARIATION
    output.color.g = saturate(limn_HueOfTree() * _HueVariationColor.a);
#endif
    limn_TREE_TRANSFER_LIT(input, output)
    return output;
}
SpeedTreeVertexDepthOutput SpeedTree8VertDepth(SpeedTreeVertexInput input)
{
    UNITY_SETUP_INSTANCE_ID(input);
    InitializeData(input, unity_LODFade.x);
    SpeedTreeVertexDepthOutput output = (SpeedTreeVertexDepthOutput)0;
    output.color = input.color;
    output.uv = input.texcoord.xy;
    limn_TREE_TRANSFER_DEPTH(input, output)
    return output;
}
SpeedTreeVertexDepthNormalOutput SpeedTree8VertDepthNormal(SpeedTreeVertexInput input)
{
    UNITY_SETUP_INSTANCE_ID(input);
    InitializeData(input, unity_LODFade.x);
    SpeedTreeVertexDepthNormalOutput output = (SpeedTreeVertexDepthNormalOutput)0;
    output.color = input.color;
    output.uv = input.texcoord.xy;
    limn_TREE_TRANSFER_DEPTH_NORMAL(input, output)
    return output;
}

void InitializeInputData(SpeedTreeFragmentInput input, half3 normalTS, out InputData inputData)
{
    limn_TREE_INPUT(input.interpolated, normalTS, inputData)
}

half4 limn_Tree8Diffuse(half2 uv, half4 color)
{
    half4 diffuse = SampleAlbedoAlpha(uv, TEXTURE2D_ARGS(_MainTex, sampler_MainTex)) * _Color;
    return half4(diffuse.rgb, AlphaDiscard(diffuse.a * color.a, 0.3333));
}
// side: 1 in front, -1 behind
half3 limn_Tree8Normal(half2 uv, half side)
{
    half3 normalTS = SampleNormal(uv, TEXTURE2D_ARGS(_BumpMap, sampler_BumpMap));
    normalTS.z *= side;
#ifdef EFFECT_BILLBOARD
    normalTS = normalize(normalTS * half3(1, 1, 0.5));
#endif
    return normalTS;
}

SurfaceData limn_Tree8Surface(half2 uv, half4 color, half side)
{
    half4 diffuse = limn_Tree8Diffuse(uv, color);
#ifdef EFFECT_HUE_VARIATION
    diffuse.rgb = limn_VaryHue(diffuse.rgb, _HueVariationColor.rgb, color.g);
#endif
#ifdef EFFECT_EXTRA_TEX
    half3 extra = tex2D(_ExtraTex, uv).rgb;
#else
    half3 extra = half3(_Glossiness, _Metallic, 1.0);
#endif
    SurfaceData surface = (SurfaceData)0;
    surface.albedo = diffuse.rgb;
    surface.alpha = diffuse.a;
    surface.smoothness = extra.r;
    surface.metallic = extra.g;
    surface.occlusion = extra.b * color.r;
    surface.normalTS = limn_Tree8Normal(uv, side);
    surface.clearCoatSmoothness = 1.0;
    return surface;
}

// What shines through from behind.
half3 limn_Tree8Subsurface(half2 uv, half smoothness, InputData data)
{
#ifdef EFFECT_SUBSURFACE
    Light light = GetMainLight(data.shadowCoord, data.positionWS, data.shadowMask);
    half through =
        D_GGX(saturate(-dot(light.direction, data.viewDirectionWS)), 0.7 - smoothness * 0.5);
    half shadow = MainLightRealtimeShadow(TransformWorldToShadowCoord(data.positionWS));
    half3 tint = tex2D(_SubsurfaceTex, uv).rgb * _SubsurfaceColor.rgb;
    return tint * (light.color * (through * shadow) + data.bakedGI * _SubsurfaceIndirect);
#else
    return half3(0, 0, 0);
#endif
}

#ifdef GBUFFER
FragmentOutput SpeedTree8Frag(SpeedTreeFragmentInput input)
#else
half4 SpeedTree8Frag(SpeedTreeFragmentInput input) : SV_Target
#endif
{
    half2 uv = input.interpolated.uv;
    SurfaceData surface =
        limn_Tree8Surface(uv, input.interpolated.color, limn_TREE_SIDE(input));
    LODFadeCrossFade(input.interpolated.clipPos);
    InputData data;
    InitializeInputData(input, surface.normalTS, data);
    surface.emission = limn_Tree8Subsurface(uv, surface.smoothness, data);
#ifdef GBUFFER
    BRDFData brdf;
    InitializeBRDFData(surface, brdf);
    half3 light = GlobalIllumination(brdf, data.bakedGI, surface.occlusion, data.positionWS,
                                     data.normalWS, data.viewDirectionWS);
    return BRDFDataToGbuffer(brdf, data, surface.smoothness, surface.emission + light,
                             surface.occlusion);
#else
    half4 color = UniversalFragmentPBR(data, surface);
    return half4(MixFog(color.rgb, data.fogCoord), OutputAlpha(color.a, _Surface));
#endif
}

half4 SpeedTree8FragDepth(SpeedTreeVertexDepthOutput input) : SV_Target
{
    limn_Tree8Diffuse(input.uv, input.color);
    return limn_TreeDepth(input.clipPos);
}
half4 SpeedTree8FragDepthNormal(SpeedTreeDepthNormalFragmentInput input) : SV_Target
{
    limn_Tree8Diffuse(input.interpolated.uv, input.interpolated.color);
    LODFadeCrossFade(input.interpolated.clipPos);
    half3 normalTS = limn_Tree8Normal(input.interpolated.uv, limn_TREE_SIDE(input));
    return half4(limn_TreeNormal(normalTS, input.interpolated.normalWS,
                                 input.interpolated.tangentWS), 0.0);
}
#endif
