// Even spreads of random numbers (0...1) over discs, spheres and lights.
#pragma once
#ifndef UNITY_SAMPLING_INCLUDED
#define UNITY_SAMPLING_INCLUDED
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonLighting.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Sampling/Fibonacci.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Sampling/Hammersley.hlsl"

// From z up to y up.
float3 TransformGLtoDX(float3 v) { return v.xzy; }
float3 ConvertEquiarealToCubemap(float u, float v)
{
    return TransformGLtoDX(SphericalToCartesian(TWO_PI * (1.0 - u), 1.0 - 2.0 * v));
}
// -1...1 over a face
float2 CubemapTexelToNVC(uint2 unPositionTXS, uint cubemapSize)
{
    return 2.0 * float2(unPositionTXS) / float(max(cubemapSize - 1u, 1u)) - 1.0;
}
// Of each face the directions of its u, of its v, and of itself.
static const float3 CUBEMAP_FACE_BASIS_MAPPING[6][3] = {
    {float3(0, 0, -1), float3(0, -1, 0), float3(1, 0, 0)},
    {float3(0, 0, 1), float3(0, -1, 0), float3(-1, 0, 0)},
    {float3(1, 0, 0), float3(0, 0, 1), float3(0, 1, 0)},
    {float3(1, 0, 0), float3(0, 0, -1), float3(0, -1, 0)},
    {float3(1, 0, 0), float3(0, -1, 0), float3(0, 0, 1)},
    {float3(-1, 0, 0), float3(0, -1, 0), float3(0, 0, -1)}};
float3 CubemapTexelToDirection(float2 positionNVC, uint faceId)
{
    float3 place = CUBEMAP_FACE_BASIS_MAPPING[faceId][2];
    place += positionNVC.x * CUBEMAP_FACE_BASIS_MAPPING[faceId][0];
    place += positionNVC.y * CUBEMAP_FACE_BASIS_MAPPING[faceId][1];
    return normalize(place);
}

float2 limn_OnCircle(float u) { return float2(cos(TWO_PI * u), sin(TWO_PI * u)); }
float2 SampleDiskUniform(float u1, float u2) { return sqrt(u1) * limn_OnCircle(u2); }
float2 SampleDiskCubic(float u1, float u2) { return u1 * limn_OnCircle(u2); }
float3 SampleConeUniform(float u1, float u2, float cos_theta)
{
    return SphericalToCartesian(TWO_PI * u2, lerp(cos_theta, 1.0, u1));
}
float3 SampleSphereUniform(float u1, float u2)
{
    return SphericalToCartesian(TWO_PI * u2, 1.0 - 2.0 * u1);
}
float3 SampleHemisphereUniform(float u1, float u2)
{
    return SphericalToCartesian(TWO_PI * u2, 1.0 - u1);
}
// The more, the nearer to z, or to a normal.
float3 SampleHemisphereCosine(float u1, float u2)
{
    return float3(SampleDiskUniform(u1, u2), sqrt(1.0 - u1));
}
float3 SampleHemisphereCosine(float u1, float u2, float3 normal)
{
    return SafeNormalize(normal + SampleSphereUniform(u1, u2));
}

// A point of a light, its normal, and how likely it is by area. Rows of localToWorld: the axes and
// the place of the light.
void SampleSphere(float2 u, float4x4 localToWorld, float radius, out float lightPdf, out float3 P,
                  out float3 Ns)
{
    float3 outward = SampleSphereUniform(u.x, u.y);
    lightPdf = 1.0 / (FOUR_PI * Sq(radius)); // all of the area is as likely
    P = localToWorld[3].xyz + outward * radius;
    Ns = outward;
}
void SampleHemisphere(float2 u, float4x4 localToWorld, float radius, out float lightPdf,
                      out float3 P, out float3 Ns)
{
    float3 local = -SampleHemisphereUniform(u.x, u.y);
    P = mul(float4(radius * local, 1.0), localToWorld).xyz;
    Ns = mul(local, (float3x3)localToWorld);
    lightPdf = 1.0 / (TWO_PI * radius * radius);
}
// Along x, without ends.
void SampleCylinder(float2 u, float4x4 localToWorld, float radius, float width,
                    out float lightPdf, out float3 P, out float3 Ns)
{
    float3 local = float3(0.0, limn_OnCircle(u.y));
    float3 place = radius * local + float3((u.x - 0.5) * width, 0.0, 0.0);
    P = mul(float4(place, 1.0), localToWorld).xyz;
    Ns = mul(local, (float3x3)localToWorld);
    lightPdf = 1.0 / (TWO_PI * radius * width);
}
void SampleRectangle(float2 u, float4x4 localToWorld, float width, float height,
                     out float lightPdf, out float3 P, out float3 Ns)
{
    P = mul(float4((u - 0.5) * float2(width, height), 0.0, 1.0), localToWorld).xyz;
    Ns = mul(float3(0.0, 0.0, -1.0), (float3x3)localToWorld);
    lightPdf = 1.0 / (width * height);
}
void SampleDisk(float2 u, float4x4 localToWorld, float radius, out float lightPdf, out float3 P,
                out float3 Ns)
{
    P = mul(float4(radius * SampleDiskUniform(u.x, u.y), 0.0, 1.0), localToWorld).xyz;
    Ns = mul(float3(0.0, 0.0, -1.0), (float3x3)localToWorld);
    lightPdf = 1.0 / (PI * radius * radius);
}
void SampleCone(float2 u, float cosHalfAngle, out float3 dir, out float rcpPdf)
{
    dir = SphericalToCartesian(TWO_PI * u.y, lerp(1.0, cosHalfAngle, u.x));
    rcpPdf = TWO_PI * (1.0 - cosHalfAngle);
}
// On a spiral out of the middle; the first direction is z.
float3 SampleConeStrata(uint sampleIdx, float rcpSampleCount, float cosHalfApexAngle)
{
    float z = 1.0 - (1.0 - cosHalfApexAngle) * sampleIdx * rcpSampleCount;
    return SphericalToCartesian(sampleIdx * GOLDEN_ANGLE, z);
}
#endif
