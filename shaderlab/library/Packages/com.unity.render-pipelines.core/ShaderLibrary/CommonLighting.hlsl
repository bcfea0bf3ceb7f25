// Geometry of lights and of directions about a surface.
#pragma once
#ifndef UNITY_COMMON_LIGHTING_INCLUDED
#define UNITY_COMMON_LIGHTING_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

// A right-angled frame about a unit vector; rows: two tangents, the vector. Duff et al. 2017,
// "Building an Orthonormal Basis, Revisited".
float3x3 GetLocalFrame(float3 localZ)
{
    float side = FastSign(localZ.z);
    float k = -1.0 / (side + localZ.z);
    float m = localZ.x * localZ.y * k;
    float3 x = float3(1.0 + side * localZ.x * localZ.x * k, side * m, -side * localZ.x);
    float3 y = float3(m, side + localZ.y * localZ.y * k, -localZ.y);
    return float3x3(x, y, localZ);
}

// A frame whose first row lies in the plane of the tangent.
float3x3 GetLocalFrame(float3 localZ, float3 localX)
{
    return float3x3(localX, cross(localZ, localX), localZ);
}

// The cosine of the angle between two directions given by polar and azimuth angle.
float SphericalDot(float cosTheta1, float phi1, float cosTheta2, float phi2)
{
    return SinFromCos(cosTheta1) * SinFromCos(cosTheta2) * cos(phi1 - phi2) + cosTheta1 * cosTheta2;
}
float3 SphericalToCartesian(float cosPhi, float sinPhi, float cosTheta)
{
    float sinTheta = SinFromCos(cosTheta);
    return float3(float2(cosPhi, sinPhi) * sinTheta, cosTheta);
}
float3 SphericalToCartesian(float phi, float cosTheta)
{
    return SphericalToCartesian(cos(phi), sin(phi), cosTheta);
}

// The inverse square law, which a window brings to 0 at the range of the light (Karis 2013).
float SmoothWindowedDistanceAttenuation(float distSquare, float distRcp,
                                        float rangeAttenuationScale, float rangeAttenuationBias)
{
    float window = saturate(rangeAttenuationBias - Sq(distSquare * rangeAttenuationScale));
    return Sq(window) * Sq(distRcp);
}
float SmoothAngleAttenuation(float cosFwd, float lightAngleScale, float lightAngleOffset)
{
    return Sq(saturate(cosFwd * lightAngleScale + lightAngleOffset));
}

// A surface seen from the side or from behind counts as seen at a grazing angle.
float ClampNdotV(float NdotV) { return max(NdotV, 0.0001); }

// Cosines about the half vector H from those about light L, view V and normal N.
void GetBSDFAngle(float3 V, float3 L, float NdotL, float NdotV, out float LdotV, out float NdotH,
                  out float LdotH, out float invLenLV)
{
    float cosine = dot(V, L);
    float inverse = rsqrt(max(2.0 + 2.0 * cosine, FLT_EPSILON)); // 1 / |L + V|
    LdotV = cosine;
    LdotH = saturate(inverse + inverse * cosine);
    NdotH = saturate(inverse * (NdotV + NdotL));
    invLenLV = inverse;
}

// Jimenez et al. 2016, "Practical Realtime Strategies for Accurate Indirect Occlusion".
float3 GTAOMultiBounce(float visibility, float3 albedo)
{
    float3 a = 2.0404 * albedo - 0.3324;
    float3 b = -4.7951 * albedo + 0.6417;
    float3 c = 2.7552 * albedo + 0.6903;
    return max(visibility.xxx, ((visibility * a + b) * visibility + c) * visibility);
}

// Lagarde and de Rousiers 2014, "Moving Frostbite to PBR".
float GetSpecularOcclusionFromAmbientOcclusion(float NdotV, float ambientOcclusion, float roughness)
{
    float power = exp2(-1.0 - 16.0 * roughness);
    float bent = PositivePow(ambientOcclusion + NdotV, power);
    return saturate(bent + ambientOcclusion - 1.0);
}

// McAuley 2011: light that reaches around the edge by w, without more of it in sum.
float ComputeWrappedDiffuseLighting(float NdotL, float w)
{
    return saturate((NdotL + w) / Sq(1.0 + w));
}

bool IsMatchingLightLayer(uint lightLayers, uint renderingLayers)
{
    return (lightLayers & renderingLayers) != 0;
}
#endif
