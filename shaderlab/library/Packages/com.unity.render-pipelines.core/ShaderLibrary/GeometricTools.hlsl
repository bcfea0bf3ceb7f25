// Rays against simple bodies, distances, and triangles against frusta.
#pragma once
#ifndef UNITY_GEOMETRICTOOLS_INCLUDED
#define UNITY_GEOMETRICTOOLS_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

// Turns about a unit vector, by Rodrigues' formula; for column vectors.
float3x3 RotationFromAxisAngle(float3 A, float sinAngle, float cosAngle)
{
    float3 k = A * (1.0 - cosAngle);
    float3 s = A * sinAngle;
    return float3x3(k.x * A.x + cosAngle, k.x * A.y - s.z, k.x * A.z + s.y,
                    k.y * A.x + s.z, k.y * A.y + cosAngle, k.y * A.z - s.x,
                    k.z * A.x - s.y, k.z * A.y + s.x, k.z * A.z + cosAngle);
}

// a t^2 + b t + c = 0; the smaller root first. False, and roots that are no numbers, where there is
// no real one.
bool SolveQuadraticEquation(float a, float b, float c, out float2 roots)
{
    float discriminant = b * b - 4.0 * a * c;
    float spread = sign(a) * sqrt(discriminant);
    roots = float2(-b - spread, -b + spread) / (2.0 * a);
    return discriminant >= 0.0;
}

// Distances are in lengths of the direction. False where the ray passes by the box within
// tMin...tMax.
bool IntersectRayAABB(float3 rayOrigin, float3 rayDirection, float3 boxMin, float3 boxMax,
                      float tMin, float tMax, out float tEntr, out float tExit)
{
    // Finite where the ray runs along a side, so that 0 * infinity does not occur.
    float limit = 1.0 / FLT_EPS;
    float3 perAxis = clamp(1.0 / rayDirection, -limit, limit);
    float3 low = (boxMin - rayOrigin) * perAxis;
    float3 high = (boxMax - rayOrigin) * perAxis;
    float3 enter = min(low, high);
    float3 leave = max(low, high);
    tEntr = max(tMin, Max3(enter.x, enter.y, enter.z));
    tExit = min(tMax, Min3(leave.x, leave.y, leave.z));
    return tEntr < tExit;
}

// From inside the box: the distance to where the ray leaves it.
float IntersectRayAABBSimple(float3 start, float3 dir, float3 boxMin, float3 boxMax)
{
    float3 leave = max((boxMin - start) / dir, (boxMax - start) / dir);
    return Min3(leave.x, leave.y, leave.z);
}

// A sphere about the origin.
bool IntersectRaySphere(float3 start, float3 dir, float radius, out float2 intersections)
{
    return SolveQuadraticEquation(dot(dir, dir), 2.0 * dot(dir, start),
                                  dot(start, start) - radius * radius, intersections);
}

// From inside a sphere about the origin, along a unit vector: the distance to where the ray leaves.
float IntersectRaySphereSimple(float3 start, float3 dir, float radius)
{
    float along = dot(dir, start);
    return abs(sqrt(along * along - dot(start, start) + radius * radius) - along);
}

float3 IntersectRayPlane(float3 rayOrigin, float3 rayDirection, float3 planeOrigin,
                         float3 planeNormal)
{
    float t = dot(planeNormal, planeOrigin - rayOrigin) / dot(planeNormal, rayDirection);
    return rayOrigin + rayDirection * t;
}

// False where the plane is behind the ray (t < 0) or along it (t = -1).
bool IntersectRayPlane(float3 rayOrigin, float3 rayDirection, float3 planePosition,
                       float3 planeNormal, out float t)
{
    t = -1.0;
    float slope = dot(planeNormal, rayDirection);
    if (abs(slope) <= 1e-5)
    {
        return false;
    }
    t = dot(planeNormal, planePosition - rayOrigin) / slope;
    return t >= 0.0;
}

bool IntersectSphereAABB(float3 position, float radius, float3 aabbMin, float3 aabbMax)
{
    float3 away = position - clamp(position, aabbMin, aabbMax);
    return dot(away, away) < radius * radius;
}

// 0 inside the box.
float DistancePointBox(float3 position, float3 boxMin, float3 boxMax)
{
    return distance(position, clamp(position, boxMin, boxMax));
}

float3 ProjectPointOnPlane(float3 position, float3 planePosition, float3 planeNormal)
{
    return position - planeNormal * dot(planeNormal, position - planePosition);
}

// plane: unit normal and minus its distance from the origin; positive on the side of the normal.
float DistanceFromPlane(float3 p, float4 plane) { return dot(plane.xyz, p) + plane.w; }

// True where one of the planes has all three corners further than -epsilon behind it.
bool CullTriangleFrustum(float3 p0, float3 p1, float3 p2, float epsilon, float4 frustumPlanes[6],
                         int numPlanes)
{
    bool outside = false;
    for (int i = 0; i < numPlanes; i++)
    {
        float4 plane = frustumPlanes[i];
        float nearest = Max3(DistanceFromPlane(p0, plane), DistanceFromPlane(p1, plane),
                             DistanceFromPlane(p2, plane));
        outside = outside || nearest < epsilon;
    }
    return outside;
}

// True where the cosine between the normal and the view is below epsilon. winding: 1 for corners in
// the order p0, p1, p2, -1 for the other way round.
bool CullTriangleBackFaceView(float3 p0, float3 p1, float3 p2, float epsilon, float3 V,
                              float winding)
{
    float3 normal = cross(p1 - p0, p2 - p0) * winding;
    return dot(normal, V) < epsilon * length(normal) * length(V);
}
bool CullTriangleBackFace(float3 p0, float3 p1, float3 p2, float epsilon, float3 viewPos,
                          float winding)
{
    return CullTriangleBackFaceView(p0, p1, p2, epsilon, viewPos - p0, winding);
}
#endif
