// Passes of the grass of URP's terrain.
#pragma once
#ifndef UNIVERSAL_WAVING_GRASS_PASSES_INCLUDED
#define UNIVERSAL_WAVING_GRASS_PASSES_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityGBuffer.hlsl"

// color.a: how much a vertex of a mesh waves; tangent.xy: from a billboard's root to its corner
struct GrassVertexInput
{
    float4 vertex : POSITION;
    float3 normal : NORMAL;
    float4 tangent : TANGENT;
    half4 color : COLOR;
    float2 texcoord : TEXCOORD0;
    float2 lightmapUV : TEXCOORD1;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct GrassVertexOutput
{
    float2 uv : TEXCOORD0;
    DECLARE_LIGHTMAP_OR_SH(lightmapUV, vertexSH, 1);
    float4 posWSShininess : TEXCOORD2;
    half3 normal : TEXCOORD3;
    half3 viewDir : TEXCOORD4;
    half4 fogFactorAndVertexLight : TEXCOORD5;
#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
    float4 shadowCoord : TEXCOORD6;
#endif
    half4 color : TEXCOORD7;
    float4 clipPos : SV_POSITION;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

void InitializeInputData(GrassVertexOutput input, out InputData inputData)
{
    float3 place = input.posWSShininess.xyz;
    float4 fogAndLight = input.fogFactorAndVertexLight;
    inputData = (InputData)0;
    inputData.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(input.clipPos);
    inputData.positionCS = input.clipPos;
    inputData.positionWS = place;
    inputData.viewDirectionWS = SafeNormalize(input.viewDir);
    inputData.normalWS = NormalizeNormalPerPixel(input.normal);
    inputData.vertexLighting = fogAndLight.yzw;
    inputData.fogCoord = InitializeInputDataFog(float4(place, 1.0), fogAndLight.x);
    inputData.shadowMask = SAMPLE_SHADOWMASK(input.lightmapUV);
    inputData.bakedGI = SAMPLE_GI(input.lightmapUV, input.vertexSH, inputData.normalWS);
#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
    inputData.shadowCoord = input.shadowCoord;
#elif defined(MAIN_LIGHT_CALCULATE_SHADOWS)
    inputData.shadowCoord = TransformWorldToShadowCoord(place);
#endif
}

void InitializeVertData(GrassVertexInput input, inout GrassVertexOutput vertData)
{
    VertexPositionInputs place = GetVertexPositionInputs(input.vertex.xyz);
    vertData.uv = input.texcoord;
    vertData.posWSShininess = float4(place.positionWS, 32.0);
    vertData.clipPos = place.positionCS;
    vertData.viewDir = SafeNormalize(GetCameraPositionWS() - place.positionWS);
    vertData.normal = TransformObjectToWorldNormal(input.normal);
    vertData.fogFactorAndVertexLight =
        half4(ComputeFogFactor(place.positionCS.z),
              VertexLighting(place.positionWS, vertData.normal));
    OUTPUT_SH(vertData.normal, vertData.vertexSH);
#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
    vertData.shadowCoord = GetShadowCoord(place);
#endif
}

GrassVertexOutput WavingGrassVert(GrassVertexInput v)
{
    GrassVertexOutput o = (GrassVertexOutput)0;
    UNITY_SETUP_INSTANCE_ID(v);
    o.color = TerrainWaveGrass(v.vertex, v.color.a * _WaveAndDistance.z, v.color);
    InitializeVertData(v, o);
    return o;
}
GrassVertexOutput WavingGrassBillboardVert(GrassVertexInput v)
{
    GrassVertexOutput o = (GrassVertexOutput)0;
    UNITY_SETUP_INSTANCE_ID(v);
    TerrainBillboardGrass(v.vertex, v.tangent.xy);
    o.color = TerrainWaveGrass(v.vertex, v.tangent.y, v.color);
    InitializeVertData(v, o);
    return o;
}

void InitializeSimpleLitSurfaceData(GrassVertexOutput input, out SurfaceData outSurfaceData)
{
    half4 color = SampleAlbedoAlpha(input.uv, TEXTURE2D_ARGS(_MainTex, sampler_MainTex));
    color *= input.color;
    outSurfaceData = (SurfaceData)0;
    outSurfaceData.alpha = AlphaDiscard(color.a, _Cutoff);
    outSurfaceData.albedo = color.rgb;
    outSurfaceData.specular = 0.1;
    outSurfaceData.smoothness = input.posWSShininess.w;
    outSurfaceData.occlusion = 1.0;
}

#ifdef TERRAIN_GBUFFER
FragmentOutput LitPassFragmentGrass(GrassVertexOutput input)
#else
half4 LitPassFragmentGrass(GrassVertexOutput input) : SV_Target
#endif
{
    SurfaceData surface;
    InitializeSimpleLitSurfaceData(input, surface);
    InputData data;
    InitializeInputData(input, data);
#ifdef TERRAIN_GBUFFER
    return SurfaceDataToGbuffer(surface, data, data.bakedGI * surface.albedo, kLightingSimpleLit);
#else
    half4 color = UniversalFragmentBlinnPhong(data, surface);
    return half4(MixFog(color.rgb, data.fogCoord),
                 OutputAlpha(surface.alpha, IsSurfaceTypeTransparent(_Surface)));
#endif
}

struct GrassVertexDepthOnlyInput
{
    float4 vertex : POSITION;
    float4 tangent : TANGENT;
    half4 color : COLOR;
    float2 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};
struct GrassVertexDepthOnlyOutput
{
    float2 uv : TEXCOORD0;
    half4 color : TEXCOORD1;
    float4 clipPos : SV_POSITION;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

void InitializeVertData(GrassVertexDepthOnlyInput input,
                        inout GrassVertexDepthOnlyOutput vertData)
{
    vertData.uv = input.texcoord;
    vertData.clipPos = TransformObjectToHClip(input.vertex.xyz);
}

GrassVertexDepthOnlyOutput DepthOnlyVertex(GrassVertexDepthOnlyInput v)
{
    GrassVertexDepthOnlyOutput o = (GrassVertexDepthOnlyOutput)0;
    UNITY_SETUP_INSTANCE_ID(v);
    o.color = TerrainWaveGrass(v.vertex, v.color.a * _WaveAndDistance.z, v.color);
    InitializeVertData(v, o);
    return o;
}

half4 DepthOnlyFragment(GrassVertexDepthOnlyOutput input) : SV_TARGET
{
    float4 texel = SampleAlbedoAlpha(input.uv, TEXTURE2D_ARGS(_MainTex, sampler_MainTex));
    Alpha(texel.a, input.color, _Cutoff);
    return input.clipPos.z;
}
#endif
