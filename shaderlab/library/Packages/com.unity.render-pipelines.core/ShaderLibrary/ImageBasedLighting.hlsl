// Light from pictures of the surroundings.
#pragma once
#define UNITY_IMAGE_BASED_LIGHTING_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/BSDF.hlsl"

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

// Radical inverse: index i of n into points that fill the square evenly.
float VanDerCorputBase2(uint i) { return reversebits(i) * (1.0 / 4294967296.0); }
float2 Hammersley2dSeq(uint i, uint sequenceLength)
{
    return float2((float)i / (float)sequenceLength, VanDerCorputBase2(i));
}
