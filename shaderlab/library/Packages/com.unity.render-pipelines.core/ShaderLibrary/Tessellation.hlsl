// How finely a patch is cut, and Phong tessellation. limn adds no vertices to a mesh, so that no
// function for factors is called.
#pragma once

#define TESSELLATION_INTERPOLATE_BARY(name, bary) \
    output.name = input0.name * bary.x + input1.name * bary.y + input2.name * bary.z

real4 CalcTriTessFactorsFromEdgeTessFactors(real3 triVertexFactors)
{
    return real4(triVertexFactors, dot(triVertexFactors, 1.0 / 3.0));
}
real3 GetDistanceBasedTessFactor(float3 p0, float3 p1, float3 p2, float3 cameraPosWS,
                                 float tessMinDist, float tessMaxDist)
{
    return 1.0;
}
real3 GetScreenSpaceTessFactor(float3 p0, float3 p1, float3 p2, float4x4 viewProjectionMatrix,
                               float4 screenSize, float triangleSize)
{
    return 1.0;
}

// Boubekeur and Alexa, Phong Tessellation (2008): towards the planes at the three corners.
float3 PhongTessellation(float3 positionWS, float3 p0, float3 p1, float3 p2, float3 n0, float3 n1,
                         float3 n2, float3 baryCoords, float shape)
{
    float3 c0 = positionWS - dot(positionWS - p0, n0) * n0;
    float3 c1 = positionWS - dot(positionWS - p1, n1) * n1;
    float3 c2 = positionWS - dot(positionWS - p2, n2) * n2;
    return lerp(positionWS, baryCoords.x * c0 + baryCoords.y * c1 + baryCoords.z * c2, shape);
}
