// Morten Mikkelsen's surface gradients: bumps from several sources add up, then bend a normal.
#pragma once
#define UNITY_NORMAL_SURFACE_GRADIENT_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

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
