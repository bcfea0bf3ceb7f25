// Terms of reflection. Roughness is the square of perceptual roughness.
#pragma once
#define UNITY_BSDF_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonLighting.hlsl"

// Schlick 1994: reflectance rises from f0 to f90 as the cosine u falls to 0.
float F_Schlick(float f0, float f90, float u)
{
    float away = 1.0 - u;
    float weight = Pow4(away) * away;
    return f0 + (f90 - f0) * weight;
}
float F_Schlick(float f0, float u) { return F_Schlick(f0, 1.0, u); }
float3 F_Schlick(float3 f0, float f90, float u)
{
    float away = 1.0 - u;
    return f0 + (f90 - f0) * (Pow4(away) * away);
}
float3 F_Schlick(float3 f0, float u) { return F_Schlick(f0, 1.0, u); }

// What is not reflected.
float F_Transm_Schlick(float f0, float f90, float u) { return 1.0 - F_Schlick(f0, f90, u); }
float F_Transm_Schlick(float f0, float u) { return 1.0 - F_Schlick(f0, 1.0, u); }

// Fresnel's equations for light without polarisation; ior = index of refraction beyond / here.
float F_FresnelDielectric(float ior, float u)
{
    float g = sqrt(max(ior * ior + u * u - 1.0, 0.0));
    float s = Sq((g - u) / (g + u));
    float t = Sq(((g + u) * u - 1.0) / ((g - u) * u + 1.0));
    return 0.5 * s * (1.0 + t);
}
float IorToFresnel0(float transmittedIor, float incidentIor)
{
    return Sq((transmittedIor - incidentIor) / (transmittedIor + incidentIor));
}
float IorToFresnel0(float transmittedIor) { return IorToFresnel0(transmittedIor, 1.0); }
float Fresnel0ToIor(float fresnel0) { return (1.0 + sqrt(fresnel0)) / (1.0 - sqrt(fresnel0)); }
float3 Fresnel0ToIor(float3 fresnel0) { return (1.0 + sqrt(fresnel0)) / (1.0 - sqrt(fresnel0)); }

// Trowbridge and Reitz 1975 (GGX): how many facets face the half vector. NoPI leaves out 1/pi.
float D_GGXNoPI(float NdotH, float roughness)
{
    float a2 = Sq(roughness);
    float d = (NdotH * a2 - NdotH) * NdotH + 1.0;
    return d != 0.0 ? a2 / Sq(d) : 0.0;
}
float D_GGX(float NdotH, float roughness) { return INV_PI * D_GGXNoPI(NdotH, roughness); }

// Burley 2012, of facets along and across.
float D_GGXAnisoNoPI(float TdotH, float BdotH, float NdotH, float roughnessT, float roughnessB)
{
    float a2 = roughnessT * roughnessB;
    float3 v = float3(roughnessB * TdotH, roughnessT * BdotH, a2 * NdotH);
    float s = dot(v, v);
    return s != 0.0 ? a2 * Sq(a2 / s) : 0.0;
}
float D_GGXAniso(float TdotH, float BdotH, float NdotH, float roughnessT, float roughnessB)
{
    return INV_PI * D_GGXAnisoNoPI(TdotH, BdotH, NdotH, roughnessT, roughnessB);
}

// Heitz 2014: facets that hide each other, height-correlated, divided by 4 NdotL NdotV.
float V_SmithJointGGX(float NdotL, float NdotV, float roughness)
{
    float a2 = Sq(roughness);
    float lambdaV = NdotL * sqrt((NdotV - a2 * NdotV) * NdotV + a2);
    float lambdaL = NdotV * sqrt((NdotL - a2 * NdotL) * NdotL + a2);
    return 0.5 / max(lambdaV + lambdaL, FLT_MIN);
}
float DV_SmithJointGGX(float NdotH, float NdotL, float NdotV, float roughness)
{
    return D_GGX(NdotH, roughness) * V_SmithJointGGX(NdotL, NdotV, roughness);
}

float LambertNoPI() { return 1.0; }
float Lambert() { return INV_PI; }

// Burley 2012: retroreflection at grazing angles on rough surfaces.
float DisneyDiffuseNoPI(float NdotV, float NdotL, float LdotV, float perceptualRoughness)
{
    float f90 = 0.5 + perceptualRoughness * (1.0 + LdotV);
    return F_Schlick(1.0, f90, NdotL) * F_Schlick(1.0, f90, NdotV);
}
float DisneyDiffuse(float NdotV, float NdotL, float LdotV, float perceptualRoughness)
{
    return INV_PI * DisneyDiffuseNoPI(NdotV, NdotL, LdotV, perceptualRoughness);
}

// Estevez and Kulla 2017: cloth, whose fibres stand up; and how they hide each other.
float D_CharlieNoPI(float NdotH, float roughness)
{
    float inverse = 1.0 / roughness;
    return (2.0 + inverse) * pow(SafeSqrt(1.0 - Sq(NdotH)), inverse) * 0.5;
}
float D_Charlie(float NdotH, float roughness) { return INV_PI * D_CharlieNoPI(NdotH, roughness); }
float V_Ashikhmin(float NdotL, float NdotV)
{
    return 1.0 / (4.0 * (NdotL + NdotV - NdotL * NdotV));
}

// Hair: Kajiya and Kay 1989 as Scheuermann 2004 has it, a highlight around the strand, and the
// tangent moved along the normal.
float3 ShiftTangent(float3 T, float3 N, float shift) { return normalize(T + N * shift); }
float D_KajiyaKay(float3 T, float3 H, float specularExponent)
{
    float along = dot(T, H);
    float across2 = saturate(1.0 - Sq(along));
    float norm = (specularExponent + 2.0) * 0.5 * INV_PI;
    return saturate(along + 1.0) * norm * PositivePow(across2, 0.5 * specularExponent);
}
