// Reflection models of the built-in pipeline: Disney diffuse with GGX (BRDF1), GGX with a visibility
// term fitted for mobile devices (BRDF2), Phong (BRDF3). Unity reads BRDF3's highlight from a texture
// (unity_NHxRoughness) that limn does not have: here it is normalised Phong.
#pragma once
#ifndef UNITY_STANDARD_BRDF_INCLUDED
#define UNITY_STANDARD_BRDF_INCLUDED
#include "UnityCG.cginc"
#include "UnityStandardConfig.cginc"
#include "UnityLightingCommon.cginc"

sampler2D_float unity_NHxRoughness; // for shaders that read it; limn gives none

float PerceptualRoughnessToRoughness(float perceptualRoughness)
{
    return perceptualRoughness * perceptualRoughness;
}
half RoughnessToPerceptualRoughness(half roughness) { return sqrt(roughness); }
half SmoothnessToRoughness(half smoothness) { return (1.0 - smoothness) * (1.0 - smoothness); }
float SmoothnessToPerceptualRoughness(float smoothness) { return 1.0 - smoothness; }

half Pow4(half x) { return x * x * x * x; }
float2 Pow4(float2 x) { return x * x * x * x; }
half3 Pow4(half3 x) { return x * x * x * x; }
half4 Pow4(half4 x) { return x * x * x * x; }
half Pow5(half x) { return x * x * x * x * x; }
half2 Pow5(half2 x) { return x * x * x * x * x; }
half3 Pow5(half3 x) { return x * x * x * x * x; }
half4 Pow5(half4 x) { return x * x * x * x * x; }

half DotClamped(half3 a, half3 b) { return saturate(dot(a, b)); }
half LambertTerm(half3 normal, half3 lightDir) { return DotClamped(normal, lightDir); }
half BlinnTerm(half3 normal, half3 halfDir) { return DotClamped(normal, halfDir); }
// Unlike normalize, defined for the zero vector, which stays zero.
float3 Unity_SafeNormalize(float3 v) { return v * rsqrt(max(0.001, dot(v, v))); }

// Schlick's Fresnel
half3 FresnelTerm(half3 F0, half cosA) { return F0 + (1.0 - F0) * Pow5(1.0 - cosA); }
half3 FresnelLerp(half3 F0, half3 F90, half cosA) { return lerp(F0, F90, Pow5(1.0 - cosA)); }
half3 FresnelLerpFast(half3 F0, half3 F90, half cosA) { return lerp(F0, F90, Pow4(1.0 - cosA)); }

// Burley's diffuse, without albedo / pi
half DisneyDiffuse(half NdotV, half NdotL, half LdotH, half perceptualRoughness)
{
    half fd90 = 0.5 + 2.0 * LdotH * LdotH * perceptualRoughness;
    half lightScatter = 1.0 + (fd90 - 1.0) * Pow5(1.0 - NdotL);
    half viewScatter = 1.0 + (fd90 - 1.0) * Pow5(1.0 - NdotV);
    return lightScatter * viewScatter;
}

// Visibility: shadowing and masking over 4 NdotL NdotV
half SmithVisibilityTerm(half NdotL, half NdotV, half k)
{
    half gL = NdotL * (1.0 - k) + k;
    half gV = NdotV * (1.0 - k) + k;
    return 1.0 / (gL * gV + 1e-5);
}
half SmithBeckmannVisibilityTerm(half NdotL, half NdotV, half roughness)
{
    return SmithVisibilityTerm(NdotL, NdotV, roughness * 0.797884560802865) * 0.25;
}
// Smith's joint term of GGX, its square roots replaced by straight lines
float SmithJointGGXVisibilityTerm(float NdotL, float NdotV, float roughness)
{
    float lambdaV = NdotL * (NdotV * (1.0 - roughness) + roughness);
    float lambdaL = NdotV * (NdotL * (1.0 - roughness) + roughness);
    return 0.5 / (lambdaV + lambdaL + 1e-5);
}
float GGXTerm(float NdotH, float roughness)
{
    float a2 = roughness * roughness;
    float d = (NdotH * a2 - NdotH) * NdotH + 1.0;
    return UNITY_INV_PI * a2 / (d * d + 1e-7);
}
half PerceptualRoughnessToSpecPower(half perceptualRoughness)
{
    half m = PerceptualRoughnessToRoughness(perceptualRoughness);
    half squared = max(1e-4, m * m);
    return max(2.0 / squared - 2.0, 1e-4);
}
half NDFBlinnPhongNormalizedTerm(half NdotH, half n)
{
    return (n + 2.0) * (0.5 / UNITY_PI) * pow(NdotH, n);
}

// The cosines between normal and light, normal and half vector, light and half vector.
float3 limn_LightCosines(float3 normal, float3 viewDir, float3 lightDir)
{
    float3 between = Unity_SafeNormalize(lightDir + viewDir);
    return saturate(float3(dot(normal, lightDir), dot(normal, between), dot(lightDir, between)));
}

half4 BRDF1_Unity_PBS(half3 diffColor, half3 specColor, half oneMinusReflectivity, half smoothness,
                      float3 normal, float3 viewDir, UnityLight light, UnityIndirect gi)
{
    float3 cosines = limn_LightCosines(normal, viewDir, light.dir);
    half nv = abs(dot(viewDir, normal));
    float perceptualRoughness = SmoothnessToPerceptualRoughness(smoothness);
    float roughness = max(PerceptualRoughnessToRoughness(perceptualRoughness), 0.002);

    // Diffuse light is not divided by pi here, so the highlight is multiplied by it.
    half3 highlight = half3(0, 0, 0);
#if !defined(_SPECULARHIGHLIGHTS_OFF)
    float facets = UNITY_PI * GGXTerm(cosines.y, roughness) *
                   SmithJointGGXVisibilityTerm(cosines.x, nv, roughness);
#ifdef UNITY_COLORSPACE_GAMMA
    facets = sqrt(max(1e-4, facets));
#endif
    float scale = any(specColor) ? 1.0 : 0.0; // a surface without any has none at its rim
    highlight = max(0.0, scale * facets * cosines.x) * FresnelTerm(specColor, cosines.z);
#endif
    half matte = cosines.x * DisneyDiffuse(nv, cosines.x, cosines.z, perceptualRoughness);
    half3 direct = light.color * (diffColor * matte + highlight);

    half3 grazing = saturate(smoothness + (1.0 - oneMinusReflectivity));
    half3 mirrored = gi.specular * FresnelLerp(specColor, grazing, nv);
#ifdef UNITY_COLORSPACE_GAMMA
    mirrored *= 1.0 - 0.28 * roughness * perceptualRoughness;
#else
    mirrored /= 1.0 + roughness * roughness;
#endif
    half3 around = gi.diffuse * diffColor + mirrored;
    return half4(direct + around, 1.0);
}

half4 BRDF2_Unity_PBS(half3 diffColor, half3 specColor, half oneMinusReflectivity, half smoothness,
                      float3 normal, float3 viewDir, UnityLight light, UnityIndirect gi)
{
    half perceptualRoughness = SmoothnessToPerceptualRoughness(smoothness);
    half roughness = PerceptualRoughnessToRoughness(perceptualRoughness);
    float3 cosines = limn_LightCosines(normal, viewDir, light.dir);

    half3 scattered = diffColor;
#if !defined(_SPECULARHIGHLIGHTS_OFF)
    // GGX, and a fit of visibility and Fresnel together.
    float a2 = roughness * roughness;
    float d = cosines.y * cosines.y * (a2 - 1.0) + 1.00001;
    float fit = max(0.1, cosines.z * cosines.z) * (4.0 * roughness + 2.0);
    scattered += a2 / (d * d * fit) * specColor;
#endif

    half3 grazing = saturate(smoothness + (1.0 - oneMinusReflectivity));
    half nv = saturate(dot(viewDir, normal));
    half3 mirrored = gi.specular * FresnelLerpFast(specColor, grazing, nv);
    half3 around =
        gi.diffuse * diffColor + mirrored * (1.0 - 0.28 * roughness * perceptualRoughness);
    return half4(scattered * light.color * cosines.x + around, 1.0);
}

// rlPow4: the fourth power of the cosine between the mirrored view direction and the light.
half3 BRDF3_Direct(half3 diffColor, half3 specColor, half rlPow4, half smoothness)
{
    // A Phong lobe looks like the Blinn-Phong lobe of four times its exponent.
    half power = PerceptualRoughnessToSpecPower(SmoothnessToPerceptualRoughness(smoothness)) / 4.0;
    half specular = pow(max(rlPow4, 0.0), power / 4.0) * (power + 1.0) / 2.0;
#if defined(_SPECULARHIGHLIGHTS_OFF)
    specular = 0.0;
#endif
    return diffColor + min(specular, 16.0) * specColor;
}
half3 BRDF3_Indirect(half3 diffColor, half3 specColor, UnityIndirect indirect, half grazingTerm,
                     half fresnelTerm)
{
    return indirect.diffuse * diffColor +
           indirect.specular * lerp(specColor, grazingTerm.xxx, fresnelTerm);
}
half4 BRDF3_Unity_PBS(half3 diffColor, half3 specColor, half oneMinusReflectivity, half smoothness,
                      float3 normal, float3 viewDir, UnityLight light, UnityIndirect gi)
{
    half mirrored = dot(light.dir, reflect(viewDir, normal));
    half3 direct = BRDF3_Direct(diffColor, specColor, Pow4(mirrored), smoothness);
    half grazing = saturate(smoothness + (1.0 - oneMinusReflectivity));
    half fresnel = Pow4(1.0 - saturate(dot(viewDir, normal)));
    half3 around = BRDF3_Indirect(diffColor, specColor, gi, grazing, fresnel);
    return half4(direct * light.color * saturate(dot(light.dir, normal)) + around, 1.0);
}
#endif
