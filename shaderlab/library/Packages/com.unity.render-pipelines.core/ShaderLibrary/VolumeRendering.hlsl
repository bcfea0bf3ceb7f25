// Light in fog. Optical depth is the integral of the extinction along a way; the transmittance is
// e to the power of minus that.
#pragma once
#ifndef UNITY_VOLUME_RENDERING_INCLUDED
#define UNITY_VOLUME_RENDERING_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonLighting.hlsl"

float TransmittanceFromOpticalDepth(float opticalDepth) { return exp(-opticalDepth); }
float3 TransmittanceFromOpticalDepth(float3 opticalDepth) { return exp(-opticalDepth); }
float OpacityFromOpticalDepth(float opticalDepth) { return 1.0 - exp(-opticalDepth); }
float3 OpacityFromOpticalDepth(float3 opticalDepth) { return 1.0 - exp(-opticalDepth); }
// An opacity of 1 has no optical depth: infinity.
float OpticalDepthFromOpacity(float opacity) { return -log(1.0 - opacity); }
float3 OpticalDepthFromOpacity(float3 opacity) { return -log(1.0 - opacity); }

// Fog that is the same everywhere.
float OpticalDepthHomogeneousMedium(float extinction, float intervalLength)
{
    return extinction * intervalLength;
}
float TransmittanceHomogeneousMedium(float extinction, float intervalLength)
{
    return exp(-extinction * intervalLength);
}
// Of the transmittance from the start of the interval to each of its points.
float TransmittanceIntegralHomogeneousMedium(float extinction, float intervalLength)
{
    return (1.0 - exp(-extinction * intervalLength)) / extinction;
}

// Fog that is the same up to the base height and thins out exponentially above it. heightExponents:
// 1/H, H; H is the height over which it falls to 1/e.
float ComputeHeightFogMultiplier(float height, float baseHeight, float2 heightExponents)
{
    return exp(-max(height - baseHeight, 0.0) * heightExponents.x);
}
float OpticalDepthHeightFog(float baseExtinction, float baseHeight, float2 heightExponents,
                            float cosZenith, float startHeight, float intervalLength)
{
    float climb = max(abs(cosZenith), 0.001);
    float lowest = min(startHeight, startHeight + intervalLength * cosZenith);
    float below = clamp((baseHeight - lowest) / climb, 0.0, intervalLength);
    float thinned = 1.0 - exp(-(intervalLength - below) * climb * heightExponents.x);
    float above = ComputeHeightFogMultiplier(lowest, baseHeight, heightExponents) * thinned *
                  heightExponents.y / climb;
    return baseExtinction * (below + above);
}
float TransmittanceHeightFog(float baseExtinction, float baseHeight, float2 heightExponents,
                             float cosZenith, float startHeight, float intervalLength)
{
    return exp(-OpticalDepthHeightFog(baseExtinction, baseHeight, heightExponents, cosZenith,
                                      startHeight, intervalLength));
}
// Upwards without an end: what lies below the base height, and H of what is above.
float OpticalDepthHeightFog(float baseExtinction, float baseHeight, float2 heightExponents,
                            float cosZenith, float startHeight)
{
    float climb = max(abs(cosZenith), REAL_EPS);
    float lowest = cosZenith >= 0.0 ? startHeight : -1.0 / REAL_EPS;
    float below = max(baseHeight - lowest, 0.0) / climb;
    float above = ComputeHeightFogMultiplier(lowest, baseHeight, heightExponents) *
                  heightExponents.y / climb;
    return baseExtinction * (below + above);
}
float TransmittanceHeightFog(float baseExtinction, float baseHeight, float2 heightExponents,
                             float cosZenith, float startHeight)
{
    return exp(-OpticalDepthHeightFog(baseExtinction, baseHeight, heightExponents, cosZenith,
                                      startHeight));
}

// How much light turns by an angle; over all directions they integrate to 1. anisotropy: -1 all
// back, 1 all ahead.
float IsotropicPhaseFunction() { return INV_FOUR_PI; }
float RayleighPhaseFunction(float cosTheta)
{
    return 0.75 * INV_FOUR_PI * (1.0 + cosTheta * cosTheta);
}
float HenyeyGreensteinPhasePartConstant(float anisotropy)
{
    return INV_FOUR_PI * (1.0 - anisotropy * anisotropy);
}
float HenyeyGreensteinPhasePartVarying(float anisotropy, float cosTheta)
{
    float x = 1.0 + anisotropy * (anisotropy - 2.0 * cosTheta);
    return pow(max(x, REAL_EPS), -1.5);
}
float HenyeyGreensteinPhaseFunction(float anisotropy, float cosTheta)
{
    return HenyeyGreensteinPhasePartConstant(anisotropy) *
           HenyeyGreensteinPhasePartVarying(anisotropy, cosTheta);
}
// Cornette and Shanks 1992: Rayleigh's where anisotropy is 0.
float CornetteShanksPhasePartConstant(float anisotropy)
{
    float g2 = anisotropy * anisotropy;
    return 1.5 * INV_FOUR_PI * (1.0 - g2) / (2.0 + g2);
}
float CornetteShanksPhasePartSymmetrical(float cosTheta) { return 1.0 + cosTheta * cosTheta; }
float CornetteShanksPhasePartAsymmetrical(float anisotropy, float cosTheta)
{
    return HenyeyGreensteinPhasePartVarying(anisotropy, cosTheta);
}
float CornetteShanksPhasePartVarying(float anisotropy, float cosTheta)
{
    return CornetteShanksPhasePartSymmetrical(cosTheta) *
           CornetteShanksPhasePartAsymmetrical(anisotropy, cosTheta);
}
float CornetteShanksPhaseFunction(float anisotropy, float cosTheta)
{
    return CornetteShanksPhasePartConstant(anisotropy) *
           CornetteShanksPhasePartVarying(anisotropy, cosTheta);
}

// A random number becomes a distance in 0...intervalLength, near ones more often as less light
// comes from far; weight: transmittance there over the density of choosing it.
void ImportanceSampleHomogeneousMedium(float rndVal, float extinction, float intervalLength,
                                       out float offset, out float weight)
{
    float opacity = 1.0 - exp(-extinction * intervalLength);
    offset = -log(1.0 - rndVal * opacity) / extinction;
    weight = opacity / extinction;
}

// The extinction that leaves a white light this colour after such a distance.
float3 TransmittanceColorAtDistanceToAbsorption(float3 transmittanceColor, float atDistance)
{
    return -log(transmittanceColor + REAL_EPS) / max(atDistance, REAL_EPS);
}
#endif
