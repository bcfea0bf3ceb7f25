// Functions that compute how finely a patch is cut. limn adds no vertices to a mesh, and so it calls
// none of them; their declarations are here because authors' functions name them.
#pragma once

float UnityCalcEdgeTessFactor(float3 wpos0, float3 wpos1, float edgeLen) { return 1.0; }
float UnityCalcDistanceTessFactor(float4 vertex, float minDist, float maxDist, float tess)
{
    return 1.0;
}
float4 UnityCalcTriEdgeTessFactors(float3 triVertexFactors) { return 1.0; }
float4 UnityDistanceBasedTess(float4 v0, float4 v1, float4 v2, float minDist, float maxDist,
                              float tess)
{
    return 1.0;
}
float4 UnityEdgeLengthBasedTess(float4 v0, float4 v1, float4 v2, float edgeLength) { return 1.0; }
float4 UnityEdgeLengthBasedTessCull(float4 v0, float4 v1, float4 v2, float edgeLength,
                                    float maxDisplacement)
{
    return 1.0;
}
