// Terms of reflection. Roughness is the square of perceptual roughness.
#pragma once
#ifndef UNITY_BSDF_INCLUDED
#define UNITY_BSDF_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonLighting.hlsl"

// What a material does with light, by the way the light takes, with the cosine.
struct CBSDF
{
    float3 diffR; // scattered back, mirrored back, and through
    float3 specR;
    float3 diffT;
    float3 specT;
};

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
float3 F_Transm_Schlick(float3 f0, float f90, float u) { return 1.0 - F_Schlick(f0, f90, u); }
float3 F_Transm_Schlick(float3 f0, float u) { return 1.0 - F_Schlick(f0, 1.0, u); }
// eta: index of refraction beyond / here
float CosCriticalAngle(float eta) { return sqrt(max(1.0 - Sq(eta), 0.0)); }

// Fresnel's equations for light without polarisation; ior = index of refraction beyond / here.
float F_FresnelDielectric(float ior, float u)
{
    float g = sqrt(max(ior * ior + u * u - 1.0, 0.0));
    float s = Sq((g - u) / (g + u));
    float t = Sq((u * (g + u) - 1.0) / (u * (g - u) + 1.0));
    return 0.5 * s * (1.0 + t);
}
// Of metals; etak2: the squared extinction (Lagarde 2013).
float3 F_FresnelConductor(float3 eta, float3 etak2, float cosTheta)
{
    float cos2 = Sq(cosTheta);
    float sin2 = 1.0 - cos2;
    float3 t = Sq(eta) - etak2 - sin2;
    float3 sum = sqrt(Sq(t) + 4.0 * Sq(eta) * etak2);
    float3 twice = 2.0 * sqrt(0.5 * (sum + t)) * cosTheta;
    float3 s = (sum + cos2 - twice) / (sum + cos2 + twice);
    float3 along = cos2 * sum + Sq(sin2);
    float3 p = s * (along - twice * sin2) / (along + twice * sin2);
    return 0.5 * (s + p);
}
float3 IorToFresnel0(float3 transmittedIor, float3 incidentIor)
{
    return Sq((transmittedIor - incidentIor) / (transmittedIor + incidentIor));
}
float IorToFresnel0(float transmittedIor, float incidentIor)
{
    return Sq((transmittedIor - incidentIor) / (transmittedIor + incidentIor));
}
float IorToFresnel0(float transmittedIor) { return IorToFresnel0(transmittedIor, 1.0); }
float Fresnel0ToIor(float fresnel0) { return (1.0 + sqrt(fresnel0)) / (1.0 - sqrt(fresnel0)); }
float3 Fresnel0ToIor(float3 fresnel0) { return (1.0 + sqrt(fresnel0)) / (1.0 - sqrt(fresnel0)); }

// The reflectance under a coat of index 1.5 of what has fresnel0 in air: polynomials near to it.
float3 ConvertF0ForAirInterfaceToF0ForClearCoat15(float3 fresnel0)
{
    float3 cubic = 0.326846 + (0.978946 - 0.283835 * fresnel0) * fresnel0;
    return saturate(-0.0256868 + fresnel0 * cubic);
}
float ConvertF0ForAirInterfaceToF0ForClearCoat15(float fresnel0)
{
    return ConvertF0ForAirInterfaceToF0ForClearCoat15(fresnel0.xxx).x;
}
float3 ConvertF0ForAirInterfaceToF0ForClearCoat15Fast(float3 fresnel0)
{
    return saturate(fresnel0 * (fresnel0 * 0.526868 + 0.529324) - 0.0482256);
}
float ConvertF0ForAirInterfaceToF0ForClearCoat15Fast(float fresnel0)
{
    return ConvertF0ForAirInterfaceToF0ForClearCoat15Fast(fresnel0.xxx).x;
}
// Gulbrandsen 2014: a metal's index and squared extinction of its colours from the front and at the
// edge.
float3 GetIorN(float3 f0, float3 edgeTint)
{
    return lerp((1.0 - f0) / (1.0 + f0), (1.0 + sqrt(f0)) / (1.0 - sqrt(f0)), edgeTint);
}
float3 getIorK2(float3 f0, float3 n) { return (Sq(n + 1.0) * f0 - Sq(f0 - 1.0)) / (1.0 - f0); }
// refract() of a direction that points away, where some of it always goes through
float3 CoatRefract(float3 X, float3 N, float ieta)
{
    float cosine = saturate(dot(N, X));
    return ieta * X + (sqrt(1.0 + ieta * ieta * (cosine * cosine - 1.0)) - ieta * cosine) * N;
}

// Heitz 2014: facets that hide each other from V, which lies about z.
float Lambda_GGX(float roughness, float3 V)
{
    return 0.5 * (sqrt(1.0 + dot(V.xy, V.xy) * Sq(roughness / V.z)) - 1.0);
}
float G_MaskingSmithGGX(float NdotV, float roughness)
{
    return 2.0 / (1.0 + sqrt(1.0 + Sq(roughness) * (1.0 / Sq(NdotV) - 1.0)));
}

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

// Heitz 2014: facets that hide each other, height-correlated, divided by 4 NdotL NdotV. What hangs
// on the view alone may be handed on.
float GetSmithJointGGXPartLambdaV(float NdotV, float roughness)
{
    float a2 = Sq(roughness);
    return sqrt((NdotV - a2 * NdotV) * NdotV + a2);
}
float V_SmithJointGGX(float NdotL, float NdotV, float roughness, float partLambdaV)
{
    float lambdaL = NdotV * GetSmithJointGGXPartLambdaV(NdotL, roughness);
    return 0.5 / max(NdotL * partLambdaV + lambdaL, FLT_MIN);
}
float V_SmithJointGGX(float NdotL, float NdotV, float roughness)
{
    return V_SmithJointGGX(NdotL, NdotV, roughness, GetSmithJointGGXPartLambdaV(NdotV, roughness));
}
float DV_SmithJointGGX(float NdotH, float NdotL, float NdotV, float roughness, float partLambdaV)
{
    return D_GGX(NdotH, roughness) * V_SmithJointGGX(NdotL, NdotV, roughness, partLambdaV);
}
float DV_SmithJointGGX(float NdotH, float NdotL, float NdotV, float roughness)
{
    return D_GGX(NdotH, roughness) * V_SmithJointGGX(NdotL, NdotV, roughness);
}
// Straight lines in place of the roots
float GetSmithJointGGXPartLambdaVApprox(float NdotV, float roughness)
{
    return lerp(NdotV, 1.0, roughness);
}
float V_SmithJointGGXApprox(float NdotL, float NdotV, float roughness, float partLambdaV)
{
    return 0.5 / (NdotL * partLambdaV + NdotV * lerp(NdotL, 1.0, roughness));
}
float V_SmithJointGGXApprox(float NdotL, float NdotV, float roughness)
{
    return V_SmithJointGGXApprox(NdotL, NdotV, roughness, lerp(NdotV, 1.0, roughness));
}
// Along and across
float GetSmithJointGGXAnisoPartLambdaV(float TdotV, float BdotV, float NdotV, float roughnessT,
                                       float roughnessB)
{
    return length(float3(roughnessT * TdotV, roughnessB * BdotV, NdotV));
}
float V_SmithJointGGXAniso(float TdotV, float BdotV, float NdotV, float TdotL, float BdotL,
                           float NdotL, float roughnessT, float roughnessB, float partLambdaV)
{
    float lambdaL =
        NdotV * GetSmithJointGGXAnisoPartLambdaV(TdotL, BdotL, NdotL, roughnessT, roughnessB);
    return 0.5 / (NdotL * partLambdaV + lambdaL);
}
float V_SmithJointGGXAniso(float TdotV, float BdotV, float NdotV, float TdotL, float BdotL,
                           float NdotL, float roughnessT, float roughnessB)
{
    return V_SmithJointGGXAniso(
        TdotV, BdotV, NdotV, TdotL, BdotL, NdotL, roughnessT, roughnessB,
        GetSmithJointGGXAnisoPartLambdaV(TdotV, BdotV, NdotV, roughnessT, roughnessB));
}
float DV_SmithJointGGXAniso(float TdotH, float BdotH, float NdotH, float NdotV, float TdotL,
                            float BdotL, float NdotL, float roughnessT, float roughnessB,
                            float partLambdaV)
{
    return D_GGXAniso(TdotH, BdotH, NdotH, roughnessT, roughnessB) *
           V_SmithJointGGXAniso(0.0, 0.0, NdotV, TdotL, BdotL, NdotL, roughnessT, roughnessB,
                                partLambdaV);
}
float DV_SmithJointGGXAniso(float TdotH, float BdotH, float NdotH, float TdotV, float BdotV,
                            float NdotV, float TdotL, float BdotL, float NdotL, float roughnessT,
                            float roughnessB)
{
    return D_GGXAniso(TdotH, BdotH, NdotH, roughnessT, roughnessB) *
           V_SmithJointGGXAniso(TdotV, BdotV, NdotV, TdotL, BdotL, NdotL, roughnessT, roughnessB);
}
// The roughness that counts towards a direction
float GetProjectedRoughness(float TdotV, float BdotV, float NdotV, float roughnessT,
                            float roughnessB)
{
    float2 across = float2(TdotV * roughnessT, BdotV * roughnessB);
    return sqrt(dot(across, across) / max(1.0 - Sq(NdotV), FLT_MIN));
}

float LambertNoPI() { return 1.0; }
float Lambert() { return INV_PI; }

// Burley 2012: retroreflection at grazing angles on rough surfaces, over what it would give a white
// surface too much.
float DisneyDiffuseNoPI(float NdotV, float NdotL, float LdotV, float perceptualRoughness)
{
    float f90 = 0.5 + perceptualRoughness * (1.0 + LdotV);
    return F_Schlick(1.0, f90, NdotL) * F_Schlick(1.0, f90, NdotV) / 1.03571;
}
float DisneyDiffuse(float NdotV, float NdotL, float LdotV, float perceptualRoughness)
{
    return INV_PI * DisneyDiffuseNoPI(NdotV, NdotL, LdotV, perceptualRoughness);
}

// Hammon 2017: light that facets scatter among each other
float3 DiffuseGGXNoPI(float3 albedo, float NdotV, float NdotL, float NdotH, float LdotV,
                      float roughness)
{
    float facing = 0.5 + 0.5 * LdotV;
    float rough = facing * (0.9 - 0.4 * facing) * (0.5 / NdotH + 1.0);
    float polished = 1.05 * F_Transm_Schlick(0.0, NdotL) * F_Transm_Schlick(0.0, NdotV);
    return lerp(polished, rough, roughness) + albedo * (roughness * 0.1159 * PI);
}
float3 DiffuseGGX(float3 albedo, float NdotV, float NdotL, float NdotH, float LdotV,
                  float roughness)
{
    return INV_PI * DiffuseGGXNoPI(albedo, NdotV, NdotL, NdotH, LdotV, roughness);
}

// Belcour and Barla 2017: thin films. How the eye sees interference at an optical path difference in
// micrometres: the Fourier transforms of Gaussians that are fitted to its curves.
float3 EvalSensitivity(float opd, float shift)
{
    float phase = TWO_PI * opd * 1e-6;
    const float4 heights = float4(5.4856e-13, 4.4201e-13, 5.2481e-13, 9.7470e-14);
    const float4 places = float4(1.6810e6, 1.7953e6, 2.2084e6, 2.2399e6);
    const float4 widths = float4(4.3278e9, 9.3046e9, 6.6121e9, 4.5282e9);
    float4 waves = heights * sqrt(TWO_PI * widths) * cos(places * phase + shift) *
                   exp(-widths * Sq(phase));
    float3 xyz = float3(waves.x + waves.w, waves.yz) / 1.0685e-7; // red has two lobes
    return mul(XYZ_2_REC709_MAT, xyz);
}

// The reflectance of a film of a thickness of 0 to 1 over a base, seen through eta_1. The thicker the
// film, the lower its index. iorOverBaseLayer: what baseLayerFresnel0 was told for; 0: this film.
float3 EvalIridescence(float eta_1, float cosTheta1, float iridescenceThickness,
                       float3 baseLayerFresnel0, float iorOverBaseLayer = 0.0)
{
    float eta = 2.0 - iridescenceThickness;
    float cos2 = 1.0 - Sq(eta_1 / eta) * (1.0 - Sq(cosTheta1));
    if (cos2 < 0.0)
    {
        return float3(1, 1, 1); // total reflection
    }
    float cosine = sqrt(cos2);
    float top = F_Schlick(IorToFresnel0(eta, eta_1), cosTheta1);
    if (iorOverBaseLayer > 0.0)
    {
        float3 baseIor = iorOverBaseLayer * Fresnel0ToIor(baseLayerFresnel0 + 0.0001);
        baseLayerFresnel0 = IorToFresnel0(baseIor, eta.xxx);
    }
    float3 base = F_Schlick(baseLayerFresnel0, cosine);

    // Light that crosses the film 0, 2, 4 … times; each crossing adds to the path.
    float3 inside = clamp(top * base, 1e-5, 0.9999);
    float3 through = Sq(1.0 - top) * base / (1.0 - inside);
    float path = 3.0 * iridescenceThickness * cosine;
    float3 seen = top + through;
    float3 share = through - (1.0 - top);
    for (int m = 1; m <= 2; ++m)
    {
        share *= sqrt(inside);
        seen += share * 2.0 * EvalSensitivity(m * path, m * PI);
    }
    return max(seen, 0.0);
}

// Estevez and Kulla 2017: cloth, whose fibres stand up; and how they hide each other.
float D_CharlieNoPI(float NdotH, float roughness)
{
    float inverse = 1.0 / roughness;
    return (2.0 + inverse) * pow(SafeSqrt(1.0 - Sq(NdotH)), inverse) * 0.5;
}
float D_Charlie(float NdotH, float roughness) { return INV_PI * D_CharlieNoPI(NdotH, roughness); }
float CharlieL(float x, float r)
{
    // The table of the paper: what is fitted for smooth cloth, and for rough cloth.
    const float4 sleek = {25.3245, 3.32435, 0.16801, -1.27393};
    const float4 coarse = {21.5473, 3.82987, 0.19823, -1.97760};
    float weight = 1.0 - Sq(1.0 - saturate(r));
    float4 fit = lerp(sleek, coarse, weight);
    float bent = fit.x / (1.0 + fit.y * PositivePow(x, fit.z));
    return bent + fit.w * x + lerp(-4.85967, -4.32054, weight);
}
float limn_CharlieLambda(float cosine, float roughness)
{
    return exp(cosine < 0.5 ? CharlieL(cosine, roughness)
                            : 2.0 * CharlieL(0.5, roughness) - CharlieL(1.0 - cosine, roughness));
}
float V_Charlie(float NdotL, float NdotV, float roughness)
{
    float lambda = limn_CharlieLambda(NdotV, roughness) + limn_CharlieLambda(NdotL, roughness);
    return 1.0 / ((1.0 + lambda) * (4.0 * NdotV * NdotL));
}
float FabricLambertNoPI(float roughness) { return 1.0 - 0.5 * roughness; }
float FabricLambert(float roughness) { return INV_PI * FabricLambertNoPI(roughness); }
float G_CookTorrance(float NdotH, float NdotV, float NdotL, float HdotV)
{
    return min(1.0, 2.0 * NdotH * min(NdotV, NdotL) / HdotV);
}
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
#endif
