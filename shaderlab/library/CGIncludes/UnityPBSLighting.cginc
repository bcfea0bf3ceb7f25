#pragma once
#ifndef UNITY_PBS_LIGHTING_INCLUDED
#define UNITY_PBS_LIGHTING_INCLUDED
#include "UnityShaderVariables.cginc"
#include "UnityStandardConfig.cginc"
#include "UnityLightingCommon.cginc"
#include "UnityGBuffer.cginc"
#include "UnityGlobalIllumination.cginc"
#include "UnityStandardBRDF.cginc"

#ifndef UNITY_BRDF_PBS
#if SHADER_TARGET < 30 || defined(UNITY_PBS_USE_BRDF3)
#define UNITY_BRDF_PBS BRDF3_Unity_PBS
#elif defined(UNITY_PBS_USE_BRDF2)
#define UNITY_BRDF_PBS BRDF2_Unity_PBS
#else
#define UNITY_BRDF_PBS BRDF1_Unity_PBS
#endif
#endif

// The term is kept for shaders that add it: what it adds is in UNITY_BRDF_PBS already.
#define UNITY_BRDF_GI BRDF_Unity_Indirect
half3 BRDF_Unity_Indirect(half3 baseColor, half3 specColor, half oneMinusReflectivity,
                          half smoothness, half3 normal, half3 viewDir, half occlusion, UnityGI gi)
{
    return half3(0, 0, 0);
}

#define UNITY_GLOSSY_ENV_FROM_SURFACE(x, s, data) \
    Unity_GlossyEnvironmentData x = UnityGlossyEnvironmentSetup( \
        s.Smoothness, data.worldViewDir, s.Normal, \
        lerp(unity_ColorSpaceDielectricSpec.rgb, s.Albedo, s.Metallic))
#define UNITY_GI(x, s, data) x = UnityGlobalIllumination(data, s.Occlusion, s.Smoothness, s.Normal)

struct SurfaceOutputStandard
{
    fixed3 Albedo; // base colour
    float3 Normal; // tangent space where it is written
    half3 Emission;
    half Metallic;
    half Smoothness;
    half Occlusion;
    fixed Alpha;
};

half4 LightingStandard(SurfaceOutputStandard s, float3 viewDir, UnityGI gi)
{
    half oneMinusReflectivity;
    half3 specColor;
    half3 albedo =
        DiffuseAndSpecularFromMetallic(s.Albedo, s.Metallic, specColor, oneMinusReflectivity);
    half outputAlpha;
    albedo = PreMultiplyAlpha(albedo, s.Alpha, oneMinusReflectivity, outputAlpha);
    half4 c = UNITY_BRDF_PBS(albedo, specColor, oneMinusReflectivity, s.Smoothness,
                             normalize(s.Normal), viewDir, gi.light, gi.indirect);
    return half4(c.rgb, outputAlpha);
}
// What goes into the targets of a deferred pass, and, given back, into the one of the light.
half4 LightingStandard_Deferred(SurfaceOutputStandard s, float3 viewDir, UnityGI gi,
                                out half4 outGBuffer0, out half4 outGBuffer1,
                                out half4 outGBuffer2)
{
    half oneMinusReflectivity;
    half3 specColor;
    half3 diffuse =
        DiffuseAndSpecularFromMetallic(s.Albedo, s.Metallic, specColor, oneMinusReflectivity);
    half3 shaded = UNITY_BRDF_PBS(diffuse, specColor, oneMinusReflectivity, s.Smoothness, s.Normal,
                                  viewDir, gi.light, gi.indirect).rgb;
    UnityStandardDataToGbuffer(
        limn_StandardData(diffuse, s.Occlusion, specColor, s.Smoothness, s.Normal), outGBuffer0,
        outGBuffer1, outGBuffer2);
    return half4(shaded + s.Emission, 1);
}
void LightingStandard_GI(SurfaceOutputStandard s, UnityGIInput data, inout UnityGI gi)
{
    gi = UnityGlobalIllumination(data, s.Occlusion, s.Smoothness, s.Normal);
}

struct SurfaceOutputStandardSpecular
{
    fixed3 Albedo; // diffuse colour
    fixed3 Specular;
    float3 Normal;
    half3 Emission;
    half Smoothness;
    half Occlusion;
    fixed Alpha;
};

half4 LightingStandardSpecular(SurfaceOutputStandardSpecular s, float3 viewDir, UnityGI gi)
{
    half oneMinusReflectivity;
    half3 albedo =
        EnergyConservationBetweenDiffuseAndSpecular(s.Albedo, s.Specular, oneMinusReflectivity);
    half outputAlpha;
    albedo = PreMultiplyAlpha(albedo, s.Alpha, oneMinusReflectivity, outputAlpha);
    half4 c = UNITY_BRDF_PBS(albedo, s.Specular, oneMinusReflectivity, s.Smoothness,
                             normalize(s.Normal), viewDir, gi.light, gi.indirect);
    return half4(c.rgb, outputAlpha);
}
half4 LightingStandardSpecular_Deferred(SurfaceOutputStandardSpecular s, float3 viewDir, UnityGI gi,
                                        out half4 outGBuffer0, out half4 outGBuffer1,
                                        out half4 outGBuffer2)
{
    half oneMinusReflectivity;
    half3 diffuse =
        EnergyConservationBetweenDiffuseAndSpecular(s.Albedo, s.Specular, oneMinusReflectivity);
    half3 shaded = UNITY_BRDF_PBS(diffuse, s.Specular, oneMinusReflectivity, s.Smoothness,
                                  s.Normal, viewDir, gi.light, gi.indirect).rgb;
    UnityStandardDataToGbuffer(
        limn_StandardData(diffuse, s.Occlusion, s.Specular, s.Smoothness, s.Normal), outGBuffer0,
        outGBuffer1, outGBuffer2);
    return half4(shaded + s.Emission, 1);
}
void LightingStandardSpecular_GI(SurfaceOutputStandardSpecular s, UnityGIInput data,
                                 inout UnityGI gi)
{
    gi = UnityGlobalIllumination(data, s.Occlusion, s.Smoothness, s.Normal);
}
#endif
