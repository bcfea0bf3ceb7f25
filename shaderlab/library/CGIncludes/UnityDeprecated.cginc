// Functions of old shaders, in groups that the including file asks for; may be included once a group.
// Those that later files kept (LambertTerm and others) are there.
#if defined(INCLUDE_UNITY_STANDARD_BRDF_DEPRECATED) && !defined(limn_BRDF_DEPRECATED)
#define limn_BRDF_DEPRECATED
#include "UnityStandardBRDF.cginc"

// Fresnel terms that roughness weakens
half3 LazarovFresnelTerm(half3 F0, half roughness, half cosA)
{
    return F0 + (1.0 - F0) * (Pow5(1.0 - cosA) / (4.0 - 3.0 * roughness));
}
half3 SebLagardeFresnelTerm(half3 F0, half roughness, half cosA)
{
    return F0 + (max(F0, roughness) - F0) * Pow5(1.0 - cosA);
}

half CookTorranceVisibilityTerm(half NdotL, half NdotV, half NdotH, half VdotH)
{
    half G = min(1.0, 2.0 * NdotH * min(NdotV, NdotL) / (VdotH + 1e-5));
    return G / (NdotL * NdotV + 1e-4);
}
half KelemenVisibilityTerm(half LdotH) { return 1.0 / (LdotH * LdotH); }
half ModifiedKelemenVisibilityTerm(half LdotH, half perceptualRoughness)
{
    half k = PerceptualRoughnessToRoughness(perceptualRoughness) * 0.797884560802865;
    return KelemenVisibilityTerm(LdotH * (1.0 - k) + k);
}
half SmithGGXVisibilityTerm(half NdotL, half NdotV, half perceptualRoughness)
{
    return SmithVisibilityTerm(NdotL, NdotV,
                               PerceptualRoughnessToRoughness(perceptualRoughness) / 2.0);
}
half ImplicitVisibilityTerm() { return 1.0; }
half RDFBlinnPhongNormalizedTerm(half NdotH, half n)
{
    return (n + 2.0) / (8.0 * UNITY_PI) * pow(NdotH, n);
}
half3 DecodeHDR_NoLinearSupportInSM2(half4 data, half4 decodeInstructions)
{
    return DecodeHDR(data, decodeInstructions);
}
half RoughnessToSpecPower(half roughness) { return PerceptualRoughnessToSpecPower(roughness); }

#define unity_LightGammaCorrectionConsts_PIDiv4 (UNITY_PI / 4)
#define unity_LightGammaCorrectionConsts_HalfDivPI (0.5 / UNITY_PI)
#define unity_LightGammaCorrectionConsts_8 (8)
#define unity_LightGammaCorrectionConsts_SqrtHalfPI (0.79788)
#endif

#if defined(INCLUDE_UNITY_IMAGE_BASED_LIGHTING_DEPRECATED) && !defined(limn_IBL_DEPRECATED)
#define limn_IBL_DEPRECATED
#include "UnityImageBasedLighting.cginc"

half3 Unity_GlossyEnvironment(UNITY_ARGS_TEXCUBE(tex), half4 hdr, half3 worldNormal,
                              half perceptualRoughness)
{
    Unity_GlossyEnvironmentData reflection;
    reflection.reflUVW = worldNormal;
    reflection.roughness = perceptualRoughness;
    return Unity_GlossyEnvironment(UNITY_PASS_TEXCUBE(tex), hdr, reflection);
}
#endif
