// Morten Mikkelsen's surface gradients: bumps from several sources add up, then bend a normal.
#pragma once
#ifndef UNITY_NORMAL_SURFACE_GRADIENT_INCLUDED
#define UNITY_NORMAL_SURFACE_GRADIENT_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

// Tangent and bitangent of any texture coordinates, by how position and they change on the screen.
void SurfaceGradientGenBasisTB(float3 nrmVertexNormal, float3 sigmaX, float3 sigmaY, float flipSign,
                               float2 texST, out float3 vT, out float3 vB)
{
    float2 dx = ddx_fine(texST);
    float2 dy = ddy_fine(texST);
    float area = dx.x * dy.y - dx.y * dy.x;
    float side = area < 0.0 ? -1.0 : 1.0;
    vT = (sigmaX * dy.y - sigmaY * dx.y) * side;
    vT = area != 0.0 ? normalize(vT) : vT;
    vB = cross(nrmVertexNormal, vT) * (side * flipSign);
}
// How far the surface rises along tangent and bitangent.
float3 SurfaceGradientFromTBN(float2 deriv, float3 vT, float3 vB)
{
    return deriv.x * vT + deriv.y * vB;
}
float3 SurfaceGradientFromPerturbedNormal(float3 nrmVertexNormal, float3 v)
{
    float s = 1.0 / max(FLT_EPSILON, abs(dot(nrmVertexNormal, v)));
    return s * (dot(nrmVertexNormal, v) * nrmVertexNormal - v);
}
float3 SurfaceGradientFromVolumeGradient(float3 nrmVertexNormal, float3 grad)
{
    return grad - dot(nrmVertexNormal, grad) * nrmVertexNormal;
}
float3 SurfaceGradientFromTriplanarProjection(float3 nrmVertexNormal, float3 triplanarWeights,
                                              float2 derivXplane, float2 derivYplane,
                                              float2 derivZplane)
{
    float3 w = triplanarWeights;
    float3 grad = float3(w.z * derivZplane.x + w.y * derivYplane.x,
                         w.z * derivZplane.y + w.x * derivXplane.y,
                         w.x * derivXplane.x + w.y * derivYplane.y);
    return SurfaceGradientFromVolumeGradient(nrmVertexNormal, grad);
}
float3 SurfaceGradientResolveNormal(float3 nrmVertexNormal, float3 surfGrad)
{
    return SafeNormalize(nrmVertexNormal - surfGrad);
}

// The slope that a normal in tangent space stands for.
float2 ConvertTangentSpaceNormalToHeightMapGradient(float2 normalXY, float rcpNormalZ, float scale)
{
    return -scale * normalXY * rcpNormalZ;
}
float3 SurfaceGradientFromTangentSpaceNormalAndFromTBN(float3 normalTS, float3 vT, float3 vB,
                                                       float scale = 1.0)
{
    float2 slope = ConvertTangentSpaceNormalToHeightMapGradient(
        normalTS.xy, 1.0 / max(normalTS.z, REAL_EPS), scale);
    return SurfaceGradientFromTBN(slope, vT, vB);
}
float2 UnpackDerivativeNormalRGB(float4 packedNormal, float scale = 1.0)
{
    float3 normal = packedNormal.rgb * 2.0 - 1.0;
    return ConvertTangentSpaceNormalToHeightMapGradient(
        normal.xy, 1.0 / max(normal.z, REAL_EPS), scale);
}
float2 UnpackDerivativeNormalAG(float4 packedNormal, float scale = 1.0)
{
    float2 xy = packedNormal.ag * 2.0 - 1.0;
    return ConvertTangentSpaceNormalToHeightMapGradient(
        xy, rsqrt(max(1.0 - dot(xy, xy), HALF_MIN_SQRT)), scale);
}
float2 UnpackDerivativeNormalRGorAG(float4 packedNormal, float scale = 1.0)
{
    packedNormal.a *= packedNormal.r;
    return UnpackDerivativeNormalAG(packedNormal, scale);
}
#endif
