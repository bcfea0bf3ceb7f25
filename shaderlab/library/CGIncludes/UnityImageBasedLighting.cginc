#pragma once
#ifndef UNITY_IMAGE_BASED_LIGHTING_INCLUDED
#define UNITY_IMAGE_BASED_LIGHTING_INCLUDED
#include "UnityCG.cginc"
#include "UnityStandardConfig.cginc"
#include "UnityStandardBRDF.cginc"

struct Unity_GlossyEnvironmentData
{
    half roughness; // perceptual
    half3 reflUVW;
};

Unity_GlossyEnvironmentData UnityGlossyEnvironmentSetup(half Smoothness, half3 worldViewDir,
                                                        half3 Normal, half3 fresnel0)
{
    Unity_GlossyEnvironmentData reflection;
    reflection.reflUVW = reflect(-worldViewDir, Normal);
    reflection.roughness = SmoothnessToPerceptualRoughness(Smoothness);
    return reflection;
}

half perceptualRoughnessToMipmapLevel(half perceptualRoughness)
{
    return perceptualRoughness * UNITY_SPECCUBE_LOD_STEPS;
}
half mipmapLevelToPerceptualRoughness(half mipmapLevel)
{
    return mipmapLevel / UNITY_SPECCUBE_LOD_STEPS;
}

half3 Unity_GlossyEnvironment(UNITY_ARGS_TEXCUBE(tex), half4 hdr,
                              Unity_GlossyEnvironmentData glossIn)
{
    // Blurred reflections follow the roughness faster than a straight line.
    half roughness = glossIn.roughness * (1.7 - 0.7 * glossIn.roughness);
    half mip = perceptualRoughnessToMipmapLevel(roughness);
    return DecodeHDR(UNITY_SAMPLE_TEXCUBE_LOD(tex, glossIn.reflUVW, mip), hdr);
}
#endif
