// Roughness, smoothness, and normals from several sources.
#pragma once
#ifndef UNITY_COMMON_MATERIAL_INCLUDED
#define UNITY_COMMON_MATERIAL_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

#define DEFAULT_SPECULAR_VALUE 0.04

#define CLEAR_COAT_IOR 1.5
#define CLEAR_COAT_IETA (1.0 / CLEAR_COAT_IOR)
#define CLEAR_COAT_F0 0.04
#define CLEAR_COAT_ROUGHNESS 0.01
#define CLEAR_COAT_PERCEPTUAL_SMOOTHNESS 0.9
#define CLEAR_COAT_PERCEPTUAL_ROUGHNESS 0.1

float PerceptualRoughnessToRoughness(float perceptualRoughness)
{
    return Sq(perceptualRoughness);
}
float RoughnessToPerceptualRoughness(float roughness) { return sqrt(roughness); }
float RoughnessToPerceptualSmoothness(float roughness) { return 1.0 - sqrt(roughness); }
float PerceptualSmoothnessToRoughness(float perceptualSmoothness)
{
    return Sq(1.0 - perceptualSmoothness);
}
float PerceptualSmoothnessToPerceptualRoughness(float perceptualSmoothness)
{
    return 1.0 - perceptualSmoothness;
}

// The exponent of a Beckmann lobe as wide, and back (Walter et al. 2007).
float BeckmannRoughnessToGGXRoughness(float roughnessBeckmann) { return 0.5 * roughnessBeckmann; }

// A point has no size: below some roughness its highlight would vanish between pixels.
float ClampRoughnessForRaytracing(float roughness) { return max(roughness, 0.001225); }
float ClampPerceptualRoughnessForRaytracing(float roughness) { return max(roughness, 0.035); }
float ClampRoughnessForAnalyticalLights(float roughness) { return max(roughness, 1.0 / 1024.0); }

// The two colours of a surface that is partly metal.
float3 ComputeDiffuseColor(float3 baseColor, float metallic)
{
    return baseColor * (1.0 - metallic);
}
float3 ComputeFresnel0(float3 baseColor, float metallic, float dielectricF0)
{
    return lerp(dielectricF0.xxx, baseColor, metallic);
}

// Anisotropy -1...1: along bitangent ... along tangent (Kulla and Conty 2017).
void ConvertValueAnisotropyToValueTB(float value, float anisotropy, out float valueT,
                                     out float valueB)
{
    valueT = value * (1.0 + anisotropy);
    valueB = value * (1.0 - anisotropy);
}
void ConvertAnisotropyToRoughness(float perceptualRoughness, float anisotropy, out float roughnessT,
                                  out float roughnessB)
{
    float roughness = PerceptualRoughnessToRoughness(perceptualRoughness);
    ConvertValueAnisotropyToValueTB(roughness, anisotropy, roughnessT, roughnessB);
}

float RoughnessToVariance(float roughness) { return 2.0 / Sq(roughness) - 2.0; }
float VarianceToRoughness(float variance) { return sqrt(2.0 / (variance + 2.0)); }

// Widens the highlight where the normal changes quickly from pixel to pixel (Tokuyoshi and
// Kaplanyan 2019).
float TextureNormalVariance(float avgNormalLength)
{
    float kappa = avgNormalLength * (3.0 - Sq(avgNormalLength)) / (1.0 - Sq(avgNormalLength));
    return avgNormalLength < 1.0 ? 0.25 / kappa : 0.0;
}
float NormalFiltering(float perceptualSmoothness, float variance, float threshold)
{
    float roughness = PerceptualSmoothnessToRoughness(perceptualSmoothness);
    float squared = saturate(Sq(roughness) + min(2.0 * variance, Sq(threshold)));
    return RoughnessToPerceptualSmoothness(sqrt(squared));
}
float GeometricNormalVariance(float3 geometricNormalWS, float screenSpaceVariance)
{
    float3 dx = ddx(geometricNormalWS);
    float3 dy = ddy(geometricNormalWS);
    return screenSpaceVariance * (dot(dx, dx) + dot(dy, dy));
}
float GeometricNormalFiltering(float perceptualSmoothness, float3 geometricNormalWS,
                               float screenSpaceVariance, float threshold)
{
    float variance = GeometricNormalVariance(geometricNormalWS, screenSpaceVariance);
    return NormalFiltering(perceptualSmoothness, variance, threshold);
}

// Whiteout blending of two normals in tangent space.
float3 BlendNormal(float3 n1, float3 n2)
{
    float2 slopes = n2.z * n1.xy + n1.z * n2.xy;
    return normalize(float3(slopes, n2.z * n1.z));
}
// Reoriented normal mapping (Barre-Brisebois and Hill 2012): n2 is turned to stand on n1.
float3 BlendNormalRNM(float3 n1, float3 n2)
{
    float3 t = n1 + float3(0.0, 0.0, 1.0);
    float3 u = n2 * float3(-1.0, -1.0, 1.0);
    return normalize(t * (dot(t, u) / t.z) - u);
}
// In world space: n1 is turned the way that leads from vtxNormal to n2.
float3 BlendNormalWorldspaceRNM(float3 n1, float3 n2, float3 vtxNormal)
{
    float cosine = dot(vtxNormal, n2);
    float3 axis = cross(vtxNormal, n2);
    return n1 * cosine + cross(axis, n1) + axis * (dot(axis, n1) / (1.0 + cosine));
}

// How much each of the three axes counts where a texture is projected along all of them.
float3 ComputeTriplanarWeights(float3 normal)
{
    float3 weights = abs(normal) - 0.2;
    weights = max(weights * weights * weights, float3(0, 0, 0));
    return weights / (weights.x + weights.y + weights.z);
}
void GetTriplanarCoordinate(float3 position, out float2 uvXZ, out float2 uvXY, out float2 uvZY)
{
    uvXZ = position.xz;
    uvXY = position.xy;
    uvZY = position.zy;
}
#endif
