// How a surface reflects: a diffuse part, a highlight of facets (GGX), and surroundings.
#pragma once
#ifndef UNIVERSAL_BRDF_INCLUDED
#define UNIVERSAL_BRDF_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/BSDF.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceData.hlsl"

// What a surface that is no metal reflects straight on, and what it does not.
#define kDielectricSpec float4(0.04, 0.04, 0.04, 1.0 - 0.04)
#define kDieletricSpec kDielectricSpec // as spelt until URP 11

struct BRDFData
{
    float3 albedo;
    float3 diffuse;
    float3 specular;
    float reflectivity;
    float perceptualRoughness;
    float roughness;
    float roughness2;
    float grazingTerm;
    float normalizationTerm;   // 4 roughness + 2
    float roughness2MinusOne;  // roughness^2 - 1
};

float ReflectivitySpecular(float3 specular) { return Max3(specular.r, specular.g, specular.b); }
float OneMinusReflectivityMetallic(float metallic) { return kDielectricSpec.a * (1.0 - metallic); }
float MetallicFromReflectivity(float reflectivity)
{
    return (reflectivity - kDielectricSpec.r) / kDielectricSpec.a;
}

void InitializeBRDFDataDirect(float3 albedo, float3 diffuse, float3 specular, float reflectivity,
                              float oneMinusReflectivity, float smoothness, inout float alpha,
                              out BRDFData outBRDFData)
{
    // Roughness keeps off zero, where the highlight would be a point without end.
    float perceptual = PerceptualSmoothnessToPerceptualRoughness(smoothness);
    float rough = max(PerceptualRoughnessToRoughness(perceptual), HALF_MIN_SQRT);
    float rough2 = max(Sq(rough), HALF_MIN);

    outBRDFData = (BRDFData)0;
    outBRDFData.perceptualRoughness = perceptual;
    outBRDFData.roughness = rough;
    outBRDFData.normalizationTerm = 4.0 * rough + 2.0;
    outBRDFData.roughness2 = rough2;
    outBRDFData.roughness2MinusOne = rough2 - 1.0;
    outBRDFData.reflectivity = reflectivity;
    outBRDFData.grazingTerm = saturate(reflectivity + smoothness);
    outBRDFData.specular = specular;
#ifdef _ALPHAPREMULTIPLY_ON
    outBRDFData.diffuse = diffuse * alpha;
#else
    outBRDFData.diffuse = diffuse;
#endif
    outBRDFData.albedo = albedo;
}
void InitializeBRDFDataDirect(float3 diffuse, float3 specular, float reflectivity,
                              float oneMinusReflectivity, float smoothness, inout float alpha,
                              out BRDFData outBRDFData)
{
    InitializeBRDFDataDirect(float3(0, 0, 0), diffuse, specular, reflectivity, oneMinusReflectivity,
                             smoothness, alpha, outBRDFData);
}

// With _SPECULAR_SETUP by the colour of the highlight, else by how much of a metal it is.
void InitializeBRDFData(float3 albedo, float metallic, float3 specular, float smoothness,
                        inout float alpha, out BRDFData outBRDFData)
{
#ifdef _SPECULAR_SETUP
    float3 mirror = specular;
    float mirrored = ReflectivitySpecular(specular);
    float scattered = 1.0 - mirrored;
#else
    float3 mirror = lerp(kDielectricSpec.rgb, albedo, metallic);
    float scattered = OneMinusReflectivityMetallic(metallic);
    float mirrored = 1.0 - scattered;
#endif
    InitializeBRDFDataDirect(albedo, albedo * scattered, mirror, mirrored, scattered, smoothness,
                             alpha, outBRDFData);
}
void InitializeBRDFData(inout SurfaceData surfaceData, out BRDFData brdfData)
{
    InitializeBRDFData(surfaceData.albedo, surfaceData.metallic, surfaceData.specular,
                       surfaceData.smoothness, surfaceData.alpha, brdfData);
}

// f0 of a surface below a coat of index 1.5 instead of below air.
float3 ConvertF0ForClearCoat15(float3 f0)
{
    float3 root = sqrt(f0);
    return saturate(Sq((1.0 - 5.0 * root) / (5.0 - root)));
}
void InitializeBRDFDataClearCoat(float clearCoatMask, float clearCoatSmoothness,
                                 inout BRDFData baseBRDFData, out BRDFData outBRDFData)
{
    float alpha = 1.0;
    InitializeBRDFDataDirect(float3(1, 1, 1), kDielectricSpec.aaa, kDielectricSpec.rgb,
                             kDielectricSpec.r, kDielectricSpec.a, clearCoatSmoothness, alpha,
                             outBRDFData);
    baseBRDFData.specular = lerp(baseBRDFData.specular,
                                 ConvertF0ForClearCoat15(baseBRDFData.specular), clearCoatMask);
}
BRDFData CreateClearCoatBRDFData(SurfaceData surfaceData, inout BRDFData brdfData)
{
    BRDFData coat = (BRDFData)0;
#if defined(_CLEARCOAT) || defined(_CLEARCOATMAP)
    InitializeBRDFDataClearCoat(surfaceData.clearCoatMask, surfaceData.clearCoatSmoothness,
                                brdfData, coat);
#endif
    return coat;
}

// What surroundings of even brightness give, without a table.
float3 EnvironmentBRDFSpecular(BRDFData brdfData, float fresnelTerm)
{
    float reduction = 1.0 / (brdfData.roughness2 + 1.0);
    return reduction * lerp(brdfData.specular, brdfData.grazingTerm.xxx, fresnelTerm);
}
float3 EnvironmentBRDF(BRDFData brdfData, float3 indirectDiffuse, float3 indirectSpecular,
                       float fresnelTerm)
{
    return indirectDiffuse * brdfData.diffuse +
           indirectSpecular * EnvironmentBRDFSpecular(brdfData, fresnelTerm);
}
float3 EnvironmentBRDFClearCoat(BRDFData brdfData, float clearCoatMask, float3 indirectSpecular,
                                float fresnelTerm)
{
    return indirectSpecular * EnvironmentBRDFSpecular(brdfData, fresnelTerm) * clearCoatMask;
}

// "Optimizing PBR for Mobile" (SIGGRAPH 2015): the GGX distribution times an approximation of
// visibility and Fresnel, roughness^2 / (d^2 max(0.1, LoH^2) (4 roughness + 2)), without 1/pi.
float DirectBRDFSpecular(BRDFData brdfData, float3 normalWS, float3 lightDirectionWS,
                         float3 viewDirectionWS)
{
    float3 halfway = SafeNormalize(lightDirectionWS + viewDirectionWS);
    float NoH = saturate(dot(normalWS, halfway));
    float LoH = saturate(dot(lightDirectionWS, halfway));
    float d = Sq(NoH) * brdfData.roughness2MinusOne + 1.00001;
    return brdfData.roughness2 / (Sq(d) * max(0.1, Sq(LoH)) * brdfData.normalizationTerm);
}
float3 DirectBDRF(BRDFData brdfData, float3 normalWS, float3 lightDirectionWS,
                  float3 viewDirectionWS, bool specularHighlightsOff)
{
    float highlight = 0.0;
    if (!specularHighlightsOff)
    {
        highlight = DirectBRDFSpecular(brdfData, normalWS, lightDirectionWS, viewDirectionWS);
    }
    return brdfData.diffuse + highlight * brdfData.specular;
}
float3 DirectBRDF(BRDFData brdfData, float3 normalWS, float3 lightDirectionWS,
                  float3 viewDirectionWS)
{
#ifdef _SPECULARHIGHLIGHTS_OFF
    return DirectBDRF(brdfData, normalWS, lightDirectionWS, viewDirectionWS, true);
#else
    return DirectBDRF(brdfData, normalWS, lightDirectionWS, viewDirectionWS, false);
#endif
}
// The name of older versions.
float3 DirectBDRF(BRDFData brdfData, float3 normalWS, float3 lightDirectionWS,
                  float3 viewDirectionWS)
{
    return DirectBRDF(brdfData, normalWS, lightDirectionWS, viewDirectionWS);
}
#endif
