// Passes of URP's terrain.
#pragma once
#ifndef UNIVERSAL_TERRAIN_LIT_PASSES_INCLUDED
#define UNIVERSAL_TERRAIN_LIT_PASSES_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityGBuffer.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DBuffer.hlsl"
#include "limn/ShadowCaster.hlsl"
#include "limn/TerrainLayers.hlsl"

struct Attributes
{
    float4 positionOS : POSITION;
    float3 normalOS : NORMAL;
    float2 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 uvMainAndLM : TEXCOORD0; // of the control texture, of the light map
#ifndef TERRAIN_SPLAT_BASEPASS
    float4 uvSplat01 : TEXCOORD1;
    float4 uvSplat23 : TEXCOORD2;
#endif
#ifdef _NORMALMAP
    half4 normal : TEXCOORD3; // w of the three: direction of view
    half4 tangent : TEXCOORD4;
    half4 bitangent : TEXCOORD5;
#else
    half3 normal : TEXCOORD3;
    half3 vertexSH : TEXCOORD4;
#endif
#ifdef _ADDITIONAL_LIGHTS_VERTEX
    half4 fogFactorAndVertexLight : TEXCOORD6;
#else
    half fogFactor : TEXCOORD6;
#endif
    float3 positionWS : TEXCOORD7;
#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
    float4 shadowCoord : TEXCOORD8;
#endif
    float4 clipPos : SV_POSITION;
    UNITY_VERTEX_OUTPUT_STEREO
};

void InitializeInputData(Varyings IN, half3 normalTS, out InputData inputData)
{
    half3 vertexSH = 0;
    inputData = (InputData)0;
    inputData.shadowMask = SAMPLE_SHADOWMASK(IN.uvMainAndLM.zw);
    inputData.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(IN.clipPos);
    inputData.positionCS = IN.clipPos;
    inputData.positionWS = IN.positionWS;
#ifdef _NORMALMAP
    half4 tangent = IN.tangent, bitangent = IN.bitangent;
    half3x3 frame = half3x3(-tangent.xyz, bitangent.xyz, IN.normal.xyz);
    inputData.tangentToWorld = frame;
    inputData.viewDirectionWS = half3(IN.normal.w, tangent.w, bitangent.w);
    half3 normal = TransformTangentToWorld(normalTS, frame);
#else
    inputData.viewDirectionWS = GetWorldSpaceNormalizeViewDir(IN.positionWS);
    half3 normal = IN.normal;
    vertexSH = IN.vertexSH;
#endif
    inputData.normalWS = NormalizeNormalPerPixel(normal);
#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
    inputData.shadowCoord = IN.shadowCoord;
#elif defined(MAIN_LIGHT_CALCULATE_SHADOWS)
    inputData.shadowCoord = TransformWorldToShadowCoord(IN.positionWS);
#endif
#ifdef _ADDITIONAL_LIGHTS_VERTEX
    half fogFactor = IN.fogFactorAndVertexLight.x;
    inputData.vertexLighting = IN.fogFactorAndVertexLight.yzw;
#else
    half fogFactor = IN.fogFactor;
#endif
    inputData.fogCoord = InitializeInputDataFog(float4(IN.positionWS, 1.0), fogFactor);
    inputData.bakedGI = SAMPLE_GI(IN.uvMainAndLM.zw, vertexSH, inputData.normalWS);
}

Varyings SplatmapVert(Attributes v)
{
    Varyings o = (Varyings)0;
    UNITY_SETUP_INSTANCE_ID(v);
    TerrainInstancing(v.positionOS, v.normalOS, v.texcoord);
    VertexPositionInputs place = GetVertexPositionInputs(v.positionOS.xyz);
    o.positionWS = place.positionWS;
    o.clipPos = place.positionCS;
    o.uvMainAndLM =
        float4(v.texcoord, v.texcoord * unity_LightmapST.xy + unity_LightmapST.zw);
#ifndef TERRAIN_SPLAT_BASEPASS
    o.uvSplat01 = float4(TRANSFORM_TEX(v.texcoord, _Splat0), TRANSFORM_TEX(v.texcoord, _Splat1));
    o.uvSplat23 = float4(TRANSFORM_TEX(v.texcoord, _Splat2), TRANSFORM_TEX(v.texcoord, _Splat3));
#endif
#ifdef _NORMALMAP
    limn_TerrainFrame(v.normalOS, place.positionWS, o.normal, o.tangent, o.bitangent);
#else
    o.normal = TransformObjectToWorldNormal(v.normalOS);
    OUTPUT_SH(o.normal, o.vertexSH);
#endif
#ifdef _ADDITIONAL_LIGHTS_VERTEX
    o.fogFactorAndVertexLight = half4(ComputeFogFactor(place.positionCS.z),
                                      VertexLighting(place.positionWS, o.normal.xyz));
#else
    o.fogFactor = ComputeFogFactor(place.positionCS.z);
#endif
#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
    o.shadowCoord = GetShadowCoord(place);
#endif
    return o;
}

#ifndef TERRAIN_SPLAT_BASEPASS
void ComputeMasks(out half4 masks[4], half4 hasMask, Varyings IN)
{
    limn_TerrainMasks(masks, hasMask, IN.uvSplat01, IN.uvSplat23);
}
#endif

SurfaceData limn_TerrainSurface(Varyings IN)
{
    SurfaceData surface = (SurfaceData)0;
    surface.clearCoatSmoothness = 1.0;
    surface.normalTS = half3(0, 0, 1);
#ifdef TERRAIN_SPLAT_BASEPASS
    half4 all = SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, IN.uvMainAndLM.xy);
    surface.albedo = all.rgb;
    surface.smoothness = all.a;
    surface.metallic = SAMPLE_TEXTURE2D(_MetallicTex, sampler_MetallicTex, IN.uvMainAndLM.xy).r;
    surface.occlusion = 1.0;
    surface.alpha = 1.0;
#else
    half4 masks[4];
    half4 hasMask = half4(_LayerHasMask0, _LayerHasMask1, _LayerHasMask2, _LayerHasMask3);
    ComputeMasks(masks, hasMask, IN);
    half4 control = limn_TerrainControl(IN.uvMainAndLM.xy);
    surface.alpha = dot(control, 1.0);
#ifdef _TERRAIN_BLEND_HEIGHT
    if (_NumLayersCount <= 4)
    {
        HeightBasedSplatModify(control, masks);
    }
#endif
    half weight;
    half4 diffuse, smoothness;
    SplatmapMix(IN.uvMainAndLM, IN.uvSplat01, IN.uvSplat23, control, weight, diffuse, smoothness,
                surface.normalTS);
    surface.albedo = diffuse.rgb;
    limn_MixTerrainMasks(masks, hasMask, control, smoothness, surface);
#endif
    return surface;
}

#ifdef TERRAIN_GBUFFER
FragmentOutput SplatmapFragment(Varyings IN)
#else
void SplatmapFragment(Varyings IN, out half4 outColor : SV_Target0)
#endif
{
#ifdef _ALPHATEST_ON
    ClipHoles(IN.uvMainAndLM.xy);
#endif
    SurfaceData surface = limn_TerrainSurface(IN);
    InputData data;
    InitializeInputData(IN, surface.normalTS, data);
#ifdef _DBUFFER
    ApplyDecal(IN.clipPos, surface.albedo, surface.specular, data.normalWS, surface.metallic,
               surface.occlusion, surface.smoothness);
#endif
#ifdef TERRAIN_GBUFFER
    BRDFData brdf;
    InitializeBRDFData(surface, brdf);
    half3 light = GlobalIllumination(brdf, data.bakedGI, surface.occlusion, data.positionWS,
                                     data.normalWS, data.viewDirectionWS);
    half4 color = half4(light, surface.alpha);
    SplatmapFinalColor(color, data.fogCoord);
    // What another pass adds to it is weighed before the light, unlike in forward passes.
    brdf.albedo *= surface.alpha;
    brdf.diffuse *= surface.alpha;
    brdf.specular *= surface.alpha;
    brdf.reflectivity *= surface.alpha;
    data.normalWS *= surface.alpha;
    return BRDFDataToGbuffer(brdf, data, surface.smoothness * surface.alpha, color.rgb,
                             surface.occlusion);
#else
    half4 color = UniversalFragmentPBR(data, surface);
    SplatmapFinalColor(color, data.fogCoord);
    outColor = half4(color.rgb, 1.0);
#endif
}

struct AttributesLean
{
    float4 position : POSITION;
    float3 normalOS : NORMAL;
    float2 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};
struct VaryingsLean
{
    float4 clipPos : SV_POSITION;
    float2 texcoord : TEXCOORD0;
    UNITY_VERTEX_OUTPUT_STEREO
};

VaryingsLean ShadowPassVertex(AttributesLean v)
{
    VaryingsLean o = (VaryingsLean)0;
    TerrainInstancing(v.position, v.normalOS, v.texcoord);
    o.clipPos = limn_ShadowCasterClip(v.position.xyz, v.normalOS);
    o.texcoord = v.texcoord;
    return o;
}
half4 ShadowPassFragment(VaryingsLean IN) : SV_TARGET
{
#ifdef _ALPHATEST_ON
    ClipHoles(IN.texcoord);
#endif
    return 0;
}

VaryingsLean DepthOnlyVertex(AttributesLean v)
{
    TerrainInstancing(v.position, v.normalOS);
    VaryingsLean o = (VaryingsLean)0;
    o.texcoord = v.texcoord;
    o.clipPos = TransformObjectToHClip(v.position.xyz);
    return o;
}
half4 DepthOnlyFragment(VaryingsLean IN) : SV_TARGET
{
#ifdef _ALPHATEST_ON
    ClipHoles(IN.texcoord);
#endif
#ifdef SCENESELECTIONPASS
    return half4(_ObjectId, _PassValue, 1.0, 1.0);
#else
    return IN.clipPos.z;
#endif
}
#endif
