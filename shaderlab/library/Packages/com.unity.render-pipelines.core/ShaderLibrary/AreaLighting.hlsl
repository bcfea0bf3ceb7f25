// Diffuse light of spheres and polygons (Baum et al. 1989; Heitz et al. 2016). limn has no area
// lights; the functions take any.
#pragma once
#ifndef UNITY_AREA_LIGHTING_INCLUDED
#define UNITY_AREA_LIGHTING_INCLUDED
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonLighting.hlsl"

// sinSqSigma: squared sine of half the angle that the sphere spans; cosOmega: between the normal
// and its middle. A fit of the part of the sphere above the horizon, 0.005 off on average.
float DiffuseSphereLightIrradiance(float sinSqSigma, float cosOmega)
{
    const float4 k = float4(0.5359050373687144, -1.0054221851257754, 1.8199061187417047,
                            -1.3172081704209504);
    const float e = 0.9245867471551246;
    float x = sinSqSigma;
    float cubic = k.x + x * (k.y + x * (k.z + x * k.w));
    return saturate(x * (cosOmega + e) * (0.5 + (cosOmega - e) * cubic));
}

// The angle between two directions about their common normal.
float3 ComputeEdgeFactor(float3 V1, float3 V2)
{
    float3 normal = cross(V1, V2);
    float sine = length(normal);
    return sine > 0.0 ? normal * (atan2(sine, dot(V1, V2)) / sine) : normal;
}
// Of the first n of five corners as seen from the surface; z: what a surface facing z gets, where
// all of it lies above the horizon.
float3 PolygonFormFactor(float4x3 L, float3 L4, uint n)
{
    float3 corners[5] = {normalize(L[0]), normalize(L[1]), normalize(L[2]), normalize(L[3]),
                         normalize(L4)};
    float3 sum = float3(0, 0, 0);
    for (uint i = 0u; i < n; ++i)
    {
        sum += ComputeEdgeFactor(corners[i], corners[i + 1u < n ? i + 1u : 0u]);
    }
    return INV_TWO_PI * sum;
}
// As of a sphere with the same factor, so that the horizon counts.
float PolygonIrradianceFromVectorFormFactor(float3 F)
{
    float l = length(F);
    return max(0.0, (l * l + F.z) / (l + 1.0));
}
float PolygonIrradiance(float4x3 L, out float3 F)
{
    F = PolygonFormFactor(L, float3(0, 0, 1), 4u);
    return PolygonIrradianceFromVectorFormFactor(F);
}
float PolygonIrradiance(float4x3 L)
{
    float3 F;
    return PolygonIrradiance(L, F);
}
#endif
