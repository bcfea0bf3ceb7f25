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

half4 BRDF1_Unity_PBS(half3 diffColor, half3 specColor, half oneMinusReflectivity, half smoothness,
                      float3 normal, float3 viewDir, UnityLight light, UnityIndirect gi)
{
    float perceptualRoughness = SmoothnessToPerceptualRoughness(smoothness);
    float3 halfDir = Unity_SafeNormalize(light.dir + viewDir);
    half nv = abs(dot(normal, viewDir));
    float nl = saturate(dot(normal, light.dir));
    float nh = saturate(dot(normal, halfDir));
    half lh = saturate(dot(light.dir, halfDir));

    half diffuseTerm = DisneyDiffuse(nv, nl, lh, perceptualRoughness) * nl;

    // Diffuse light is not divided by pi here, so specular light is multiplied by it.
    float roughness = max(PerceptualRoughnessToRoughness(perceptualRoughness), 0.002);
    float specularTerm =
        SmithJointGGXVisibilityTerm(nl, nv, roughness) * GGXTerm(nh, roughness) * UNITY_PI;
    specularTerm = max(0.0, specularTerm * nl);
#if defined(_SPECULARHIGHLIGHTS_OFF)
    specularTerm = 0.0;
#endif
    specularTerm *= any(specColor) ? 1.0 : 0.0;

    half surfaceReduction = 1.0 / (roughness * roughness + 1.0);
    half grazingTerm = saturate(smoothness + (1.0 - oneMinusReflectivity));
    half3 color = diffColor * (gi.diffuse + light.color * diffuseTerm) +
                  specularTerm * light.color * FresnelTerm(specColor, lh) +
                  surfaceReduction * gi.specular * FresnelLerp(specColor, grazingTerm.xxx, nv);
    return half4(color, 1.0);
}

half4 BRDF2_Unity_PBS(half3 diffColor, half3 specColor, half oneMinusReflectivity, half smoothness,
                      float3 normal, float3 viewDir, UnityLight light, UnityIndirect gi)
{
    float3 halfDir = Unity_SafeNormalize(light.dir + viewDir);
    half nl = saturate(dot(normal, light.dir));
    float nh = saturate(dot(normal, halfDir));
    half nv = saturate(dot(normal, viewDir));
    float lh = saturate(dot(light.dir, halfDir));

    half perceptualRoughness = SmoothnessToPerceptualRoughness(smoothness);
    half roughness = PerceptualRoughnessToRoughness(perceptualRoughness);
    float a2 = roughness * roughness;
    float d = nh * nh * (a2 - 1.0) + 1.00001;
    float specularTerm = a2 / (max(0.1, lh * lh) * (roughness + 0.5) * (d * d) * 4.0);
#if defined(_SPECULARHIGHLIGHTS_OFF)
    specularTerm = 0.0;
#endif

    half surfaceReduction = 1.0 - roughness * perceptualRoughness * 0.28;
    half grazingTerm = saturate(smoothness + (1.0 - oneMinusReflectivity));
    half3 color = (diffColor + specularTerm * specColor) * light.color * nl +
                  gi.diffuse * diffColor +
                  surfaceReduction * gi.specular * FresnelLerpFast(specColor, grazingTerm.xxx, nv);
    return half4(color, 1.0);
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
    half nl = saturate(dot(normal, light.dir));
    half nv = saturate(dot(normal, viewDir));
    half2 pow4 = Pow4(float2(dot(reflect(viewDir, normal), light.dir), 1.0 - nv));
    half grazingTerm = saturate(smoothness + (1.0 - oneMinusReflectivity));
    half3 color = BRDF3_Direct(diffColor, specColor, pow4.x, smoothness) * light.color * nl +
                  BRDF3_Indirect(diffColor, specColor, gi, grazingTerm, pow4.y);
    return half4(color, 1.0);
}
#endif
