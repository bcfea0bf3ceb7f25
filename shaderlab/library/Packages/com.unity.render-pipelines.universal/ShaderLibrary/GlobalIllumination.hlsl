// Ambient light and what surfaces reflect. There are no light maps and no reflection probes.
#pragma once
#ifndef UNIVERSAL_GLOBAL_ILLUMINATION_INCLUDED
#define UNIVERSAL_GLOBAL_ILLUMINATION_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/EntityLighting.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/ImageBasedLighting.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/BRDF.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/RealtimeLights.hlsl"

// Where harmonics are evaluated: by default all in the fragment function; EVALUATE_SH_VERTEX: all
// in the vertex function; EVALUATE_SH_MIXED: order 2 there, orders 0 and 1 here.
float3 SampleSH(float3 normalWS)
{
    float3 light = SHEvalLinearL0L1(normalWS, unity_SHAr, unity_SHAg, unity_SHAb) +
                   SHEvalLinearL2(normalWS, unity_SHBr, unity_SHBg, unity_SHBb, unity_SHC);
    return max(float3(0, 0, 0), limn_InActiveSpace(light));
}
float3 SampleSHVertex(float3 normalWS)
{
#if defined(EVALUATE_SH_VERTEX)
    return SampleSH(normalWS);
#elif defined(EVALUATE_SH_MIXED)
    return SHEvalLinearL2(normalWS, unity_SHBr, unity_SHBg, unity_SHBb, unity_SHC);
#else
    return float3(0, 0, 0);
#endif
}
float3 SampleSHPixel(float3 L2Term, float3 normalWS)
{
#if defined(EVALUATE_SH_VERTEX)
    return L2Term;
#elif defined(EVALUATE_SH_MIXED)
    float3 light = L2Term + SHEvalLinearL0L1(normalWS, unity_SHAr, unity_SHAg, unity_SHAb);
    return max(float3(0, 0, 0), limn_InActiveSpace(light));
#else
    return SampleSH(normalWS);
#endif
}

#define DECLARE_LIGHTMAP_OR_SH(lmName, shName, index) float3 shName : TEXCOORD##index
#define OUTPUT_LIGHTMAP_UV(lightmapUV, lightmapScaleOffset, OUT)
#define OUTPUT_SH(normalWS, OUT) OUT.xyz = SampleSHVertex(normalWS)
// Unity 6's; limn has no probe volumes, whose occlusion the last would be.
#define OUTPUT_SH4(absolutePositionWS, normalWS, viewDir, OUT, OUT_OCCLUSION) OUTPUT_SH(normalWS, OUT)
#if defined(LIGHTMAP_ON) || defined(DYNAMICLIGHTMAP_ON)
[limn_Lacks("light maps", "the ambient light stands in for them")]
float3 limn_AmbientForLightmap(float3 ambient) { return ambient; }
#define SAMPLE_GI(lmName, shName, normalWSName) \
    limn_AmbientForLightmap(SampleSHPixel(shName, normalWSName))
#else
#define SAMPLE_GI(lmName, shName, normalWSName) SampleSHPixel(shName, normalWSName)
#endif

[limn_Lacks("light maps", "they are white")]
float3 SampleLightmap(float2 staticLightmapUV, float3 normalWS) { return float3(1, 1, 1); }
float3 SampleLightmap(float2 staticLightmapUV, float2 dynamicLightmapUV, float3 normalWS)
{
    return SampleLightmap(staticLightmapUV, normalWS);
}

// The reflection of the scene's sky, blurred as rough surfaces do; where the scene has none, the
// ambient light from that side.
float3 GlossyEnvironmentReflection(float3 reflectVector, float perceptualRoughness, float occlusion)
{
#if defined(_ENVIRONMENTREFLECTIONS_OFF)
    return _GlossyEnvironmentColor.rgb * occlusion;
#else
    bool hasSky = unity_SpecCube0_HDR.y > 0.0;
    if (!hasSky)
    {
        return SampleSH(reflectVector) * occlusion;
    }
    float level = PerceptualRoughnessToMipmapLevel(perceptualRoughness);
    float4 encoded =
        SAMPLE_TEXTURECUBE_LOD(unity_SpecCube0, samplerunity_SpecCube0, reflectVector, level);
    return DecodeHDREnvironment(encoded, unity_SpecCube0_HDR) * occlusion;
#endif
}
float3 GlossyEnvironmentReflection(float3 reflectVector, float3 positionWS,
                                   float perceptualRoughness, float occlusion)
{
    return GlossyEnvironmentReflection(reflectVector, perceptualRoughness, occlusion);
}
float3 GlossyEnvironmentReflection(float3 reflectVector, float3 positionWS,
                                   float perceptualRoughness, float occlusion,
                                   float2 normalizedScreenSpaceUV)
{
    return GlossyEnvironmentReflection(reflectVector, perceptualRoughness, occlusion);
}

// Where a reflection that leaves positionWS meets the box of a probe, seen from the probe. A position
// with w = 0 is a probe without a box.
float3 BoxProjectedCubemapDirection(float3 reflectionWS, float3 positionWS,
                                    float4 cubemapPositionWS, float4 boxMin, float4 boxMax)
{
    if (cubemapPositionWS.w <= 0.0)
    {
        return reflectionWS;
    }
    float3 wall = reflectionWS > 0.0 ? boxMax.xyz : boxMin.xyz;
    float3 distances = (wall - positionWS) / reflectionWS;
    float nearest = min(distances.x, min(distances.y, distances.z));
    return positionWS - cubemapPositionWS.xyz + reflectionWS * nearest;
}

// Baked light holds no light of the main light: there is nothing to take away.
float3 SubtractDirectMainLightFromLightmap(Light mainLight, float3 normalWS, float3 bakedGI)
{
    return bakedGI;
}
void MixRealtimeAndBakedGI(inout Light light, float3 normalWS, inout float3 bakedGI) {}
void MixRealtimeAndBakedGI(inout Light light, float3 normalWS, inout float3 bakedGI,
                           float4 shadowMask)
{
}
void MixRealtimeAndBakedGI(inout Light light, float3 normalWS, inout float3 bakedGI,
                           AmbientOcclusionFactor aoFactor)
{
    bakedGI *= aoFactor.indirectAmbientOcclusion;
}

float3 GlobalIllumination(BRDFData brdfData, BRDFData brdfDataClearCoat, float clearCoatMask,
                          float3 bakedGI, float occlusion, float3 positionWS, float3 normalWS,
                          float3 viewDirectionWS, float2 normalizedScreenSpaceUV)
{
    float3 reflectVector = reflect(-viewDirectionWS, normalWS);
    float NoV = saturate(dot(normalWS, viewDirectionWS));
    float fresnelTerm = Pow4(1.0 - NoV);
    float3 reflected =
        GlossyEnvironmentReflection(reflectVector, brdfData.perceptualRoughness, 1.0);
    float3 color = EnvironmentBRDF(brdfData, bakedGI, reflected, fresnelTerm);
#if defined(_CLEARCOAT) || defined(_CLEARCOATMAP)
    float3 coatReflected =
        GlossyEnvironmentReflection(reflectVector, brdfDataClearCoat.perceptualRoughness, 1.0);
    float3 coat =
        EnvironmentBRDFClearCoat(brdfDataClearCoat, clearCoatMask, coatReflected, fresnelTerm);
    // What the coat mirrors does not reach the surface below it.
    float taken = clearCoatMask * (fresnelTerm * kDielectricSpec.a + kDielectricSpec.x);
    return (coat + color * (1.0 - taken)) * occlusion;
#else
    return color * occlusion;
#endif
}
float3 GlobalIllumination(BRDFData brdfData, BRDFData brdfDataClearCoat, float clearCoatMask,
                          float3 bakedGI, float occlusion, float3 positionWS, float3 normalWS,
                          float3 viewDirectionWS)
{
    return GlobalIllumination(brdfData, brdfDataClearCoat, clearCoatMask, bakedGI, occlusion,
                              positionWS, normalWS, viewDirectionWS, float2(0, 0));
}
float3 GlobalIllumination(BRDFData brdfData, float3 bakedGI, float occlusion, float3 positionWS,
                          float3 normalWS, float3 viewDirectionWS)
{
    return GlobalIllumination(brdfData, (BRDFData)0, 0.0, bakedGI, occlusion, positionWS, normalWS,
                              viewDirectionWS, float2(0, 0));
}
float3 GlobalIllumination(BRDFData brdfData, BRDFData brdfDataClearCoat, float clearCoatMask,
                          float3 bakedGI, float occlusion, float3 normalWS, float3 viewDirectionWS)
{
    return GlobalIllumination(brdfData, brdfDataClearCoat, clearCoatMask, bakedGI, occlusion,
                              float3(0, 0, 0), normalWS, viewDirectionWS, float2(0, 0));
}
float3 GlobalIllumination(BRDFData brdfData, float3 bakedGI, float occlusion, float3 normalWS,
                          float3 viewDirectionWS)
{
    return GlobalIllumination(brdfData, (BRDFData)0, 0.0, bakedGI, occlusion, float3(0, 0, 0),
                              normalWS, viewDirectionWS, float2(0, 0));
}
#endif
