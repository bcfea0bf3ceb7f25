// Light that goes through an object: what lies behind is seen from rayWS at positionWS.
#pragma once
#ifndef UNITY_REFRACTION_INCLUDED
#define UNITY_REFRACTION_INCLUDED
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

struct RefractionModelResult
{
    float dist; // through the object
    float3 positionWS;
    float3 rayWS;
};

// A ball of diameter `thickness` that touches the surface from within: refracted twice.
RefractionModelResult RefractionModelSphere(float3 V, float3 positionWS, float3 normalWS,
                                            float ior, float thickness)
{
    float3 within = refract(-V, normalWS, 1.0 / ior);
    float3 centre = positionWS - normalWS * (thickness * 0.5);
    RefractionModelResult result;
    result.dist = -dot(normalWS, within) * thickness;
    result.positionWS = positionWS + within * result.dist;
    result.rayWS = refract(within, SafeNormalize(centre - result.positionWS), ior);
    return result;
}
// A slab: the ray goes on as it came, shifted.
RefractionModelResult RefractionModelBox(float3 V, float3 positionWS, float3 normalWS, float ior,
                                         float thickness)
{
    float3 within = refract(-V, normalWS, 1.0 / ior);
    RefractionModelResult result;
    result.dist = thickness / max(dot(within, -normalWS), 1e-5);
    result.positionWS = positionWS + within * result.dist;
    result.rayWS = -V;
    return result;
}
#endif
