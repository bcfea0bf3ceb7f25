// Light from pictures of the surroundings.
#pragma once
#ifndef UNITY_IMAGE_BASED_LIGHTING_HLSL_INCLUDED
#define UNITY_IMAGE_BASED_LIGHTING_HLSL_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/BSDF.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Sampling/Sampling.hlsl"

// Levels of a reflection probe that are blurred for rougher and rougher surfaces.
#ifndef UNITY_SPECCUBE_LOD_STEPS
#define UNITY_SPECCUBE_LOD_STEPS 6
#endif

// The levels are not spread evenly over perceptual roughness.
float PerceptualRoughnessToMipmapLevel(float perceptualRoughness, uint maxMipLevel)
{
    return perceptualRoughness * (1.7 - 0.7 * perceptualRoughness) * maxMipLevel;
}
float PerceptualRoughnessToMipmapLevel(float perceptualRoughness)
{
    return PerceptualRoughnessToMipmapLevel(perceptualRoughness, UNITY_SPECCUBE_LOD_STEPS);
}
float MipmapLevelToPerceptualRoughness(float mipmapLevel)
{
    float part = saturate(mipmapLevel / UNITY_SPECCUBE_LOD_STEPS);
    return saturate((1.7 - sqrt(2.89 - 2.8 * part)) / 1.4);
}

// As above, and less blurred where the surface is seen from the side.
float PerceptualRoughnessToMipmapLevel(float perceptualRoughness, float NdotR)
{
    float m = PerceptualRoughnessToRoughness(perceptualRoughness);
    float n = 2.0 / max(FLT_EPSILON, m * m) - 2.0;
    n /= 4.0 * max(NdotR, FLT_EPSILON);
    return pow(2.0 / (n + 2.0), 0.25) * UNITY_SPECCUBE_LOD_STEPS;
}

// Normals that stretch reflections across the grain; anisotropy 0...1, or -1...1 where both
// directions are given.
float3 ComputeViewFacingNormal(float3 V, float3 T) { return Orthonormalize(V, T); }
float3 GetAnisotropicModifiedNormal(float3 grainDir, float3 N, float3 V, float anisotropy)
{
    return normalize(lerp(N, ComputeViewFacingNormal(V, grainDir), anisotropy));
}
void GetGGXAnisotropicModifiedNormalAndRoughness(float3 bitangentWS, float3 tangentWS, float3 N,
                                                 float3 V, float anisotropy,
                                                 float perceptualRoughness, out float3 iblN,
                                                 out float iblPerceptualRoughness)
{
    float strength = abs(anisotropy);
    iblPerceptualRoughness = saturate(1.2 - strength) * perceptualRoughness;
    float bend = strength * saturate(sqrt(perceptualRoughness) * 1.5);
    iblN = GetAnisotropicModifiedNormal(anisotropy < 0.0 ? tangentWS : bitangentWS, N, V, bend);
}
// Lagarde and de Rousiers 2014: the rougher, the nearer to the normal. Not of unit length.
float3 GetSpecularDominantDir(float3 N, float3 R, float perceptualRoughness, float NdotV)
{
    float p2 = Sq(perceptualRoughness);
    float a = 1.0 - p2;
    return lerp(N, R, (sqrt(a) + p2) * saturate(a * a + a * NdotV * NdotV));
}

// Directions as likely as the material reflects there. u: two random numbers of 0...1; rows of
// localToWorld: tangent, bitangent, normal.
void SampleGGXDir(float2 u, float3 V, float3x3 localToWorld, float roughness, out float3 L,
                  out float NdotL, out float NdotH, out float VdotH, bool VeqN = false)
{
    float spread = Sq(roughness) - 1.0;
    NdotH = sqrt(SafeDiv(1.0 - u.x, spread * u.x + 1.0));
    float3 localH = SphericalToCartesian(TWO_PI * u.y, NdotH);
    float3 localV = VeqN ? float3(0, 0, 1) : mul(localToWorld, V);
    VdotH = VeqN ? NdotH : saturate(dot(localV, localH));
    float3 localL = 2.0 * VdotH * localH - localV;
    NdotL = localL.z;
    L = mul(localL, localToWorld);
}
void SampleAnisoGGXDir(float2 u, float3 V, float3 N, float3 tangentX, float3 tangentY,
                       float roughnessT, float roughnessB, out float3 H, out float3 L)
{
    float2 at = sqrt(u.x / (1.0 - u.x)) * float2(roughnessT, roughnessB) * limn_OnCircle(u.y);
    H = normalize(at.x * tangentX + at.y * tangentY + N);
    L = 2.0 * saturate(dot(V, H)) * H - V;
}
// Heitz 2018: only facets that the viewer sees.
void SampleAnisoGGXVisibleNormal(float2 u, float3 V, float3x3 localToWorld, float roughnessX,
                                 float roughnessY, out float3 localV, out float3 localH,
                                 out float VdotH)
{
    localV = mul(localToWorld, V);
    float3 z = normalize(float3(roughnessX, roughnessY, 1.0) * localV);
    float3 x = z.z < 0.9999 ? normalize(cross(float3(0, 0, 1), z)) : float3(1, 0, 0);
    float2 t = SampleDiskUniform(u.x, u.y);
    t.y = lerp(sqrt(1.0 - t.x * t.x), t.y, 0.5 * (1.0 + z.z));
    float3 h = t.x * x + t.y * cross(z, x) + SafeSqrt(1.0 - dot(t, t)) * z;
    localH = normalize(float3(roughnessX * h.x, roughnessY * h.y, max(0.0, h.z)));
    VdotH = saturate(dot(localV, localH));
}
void SampleGGXVisibleNormal(float2 u, float3 V, float3x3 localToWorld, float roughness,
                            out float3 localV, out float3 localH, out float VdotH)
{
    SampleAnisoGGXVisibleNormal(u, V, localToWorld, roughness, roughness, localV, localH, VdotH);
}

// The same with what the material does there, without its colour or Fresnel's term, over how likely
// the direction is.
void ImportanceSampleLambert(float2 u, float3x3 localToWorld, out float3 L, out float NdotL,
                             out float weightOverPdf)
{
    L = SampleHemisphereCosine(u.x, u.y, localToWorld[2]);
    NdotL = saturate(dot(localToWorld[2], L));
    weightOverPdf = 1.0;
}
void ImportanceSampleGGX(float2 u, float3 V, float3x3 localToWorld, float roughness, float NdotV,
                         out float3 L, out float VdotH, out float NdotL, out float weightOverPdf)
{
    float NdotH;
    SampleGGXDir(u, V, localToWorld, roughness, L, NdotL, NdotH, VdotH);
    weightOverPdf = 4.0 * V_SmithJointGGX(NdotL, NdotV, roughness) * NdotL * VdotH / NdotH;
}
void ImportanceSampleAnisoGGX(float2 u, float3 V, float3x3 localToWorld, float roughnessT,
                              float roughnessB, float NdotV, out float3 L, out float VdotH,
                              out float NdotL, out float weightOverPdf)
{
    float3 H;
    SampleAnisoGGXDir(u, V, localToWorld[2], localToWorld[0], localToWorld[1], roughnessT,
                      roughnessB, H, L);
    VdotH = saturate(dot(V, H));
    NdotL = saturate(dot(localToWorld[2], L));
    float vis = V_SmithJointGGXAniso(dot(localToWorld[0], V), dot(localToWorld[1], V), NdotV,
                                     dot(localToWorld[0], L), dot(localToWorld[1], L), NdotL,
                                     roughnessT, roughnessB);
    weightOverPdf = 4.0 * vis * NdotL * VdotH / saturate(dot(localToWorld[2], H));
}

// x and y: of f0 = 0 and f0 = 1 what GGX reflects of light from everywhere; z: Disney's diffuse
// term, less 0.5.
float4 IntegrateGGXAndDisneyDiffuseFGD(float NdotV, float roughness, uint sampleCount = 4096)
{
    NdotV = max(NdotV, FLT_EPSILON);
    float3 V = float3(sqrt(1.0 - NdotV * NdotV), 0.0, NdotV);
    float3x3 frame = float3x3(1, 0, 0, 0, 1, 0, 0, 0, 1);
    float4 sum = float4(0, 0, 0, 0);
    for (uint i = 0u; i < sampleCount; ++i)
    {
        float2 u = Hammersley2d(i, sampleCount);
        float3 L;
        float VdotH, NdotL, weight;
        ImportanceSampleGGX(u, V, frame, roughness, NdotV, L, VdotH, NdotL, weight);
        sum.xy += NdotL > 0.0 ? weight * float2(pow(1.0 - VdotH, 5.0), 1.0) : float2(0, 0);
        ImportanceSampleLambert(u, frame, L, NdotL, weight);
        float diffuse = DisneyDiffuseNoPI(NdotV, NdotL, dot(L, V), sqrt(roughness));
        sum.z += NdotL > 0.0 ? diffuse : 0.0;
    }
    sum /= sampleCount;
    return float4(sum.xy, sum.z - 0.5, sum.w);
}

uint GetIBLRuntimeFilterSampleCount(uint mipLevel)
{
    const uint counts[7] = {0, 21, 34, 55, 89, 89, 89};
    return mipLevel < 7u ? counts[mipLevel] : 0u;
}
// 1 towards the middle of a probe, 0 away from it
float InfluenceFadeNormalWeight(float3 normal, float3 centerToPos)
{
    return saturate(1.5 - 2.5 * dot(normal, centerToPos));
}
#endif
