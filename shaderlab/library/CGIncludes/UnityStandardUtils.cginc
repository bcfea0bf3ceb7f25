#pragma once
#ifndef UNITY_STANDARD_UTILS_INCLUDED
#define UNITY_STANDARD_UTILS_INCLUDED
#include "UnityCG.cginc"
#include "UnityStandardConfig.cginc"

half SpecularStrength(half3 specular) { return max(max(specular.r, specular.g), specular.b); }

// What is mirrored is not scattered: albedo is darkened by the specular colour.
half3 EnergyConservationBetweenDiffuseAndSpecular(half3 albedo, half3 specColor,
                                                  out half oneMinusReflectivity)
{
    oneMinusReflectivity = 1.0 - SpecularStrength(specColor);
#if UNITY_CONSERVE_ENERGY_MONOCHROME
    return albedo * oneMinusReflectivity;
#else
    return albedo * (half3(1, 1, 1) - specColor);
#endif
}

// Dielectrics mirror 4 percent, metals everything.
half OneMinusReflectivityFromMetallic(half metallic)
{
    half dielectric = unity_ColorSpaceDielectricSpec.a;
    return dielectric - metallic * dielectric;
}
half3 DiffuseAndSpecularFromMetallic(half3 albedo, half metallic, out half3 specColor,
                                     out half oneMinusReflectivity)
{
    half scattered = OneMinusReflectivityFromMetallic(metallic);
    oneMinusReflectivity = scattered;
    specColor = lerp(unity_ColorSpaceDielectricSpec.rgb, albedo, metallic);
    return scattered * albedo;
}

// For blending One, OneMinusSrcAlpha: reflections stay on what is transparent.
half3 PreMultiplyAlpha(half3 diffColor, half alpha, half oneMinusReflectivity,
                       out half outModifiedAlpha)
{
#if defined(_ALPHAPREMULTIPLY_ON)
    outModifiedAlpha = 1.0 - oneMinusReflectivity + alpha * oneMinusReflectivity;
    return diffColor * alpha;
#else
    outModifiedAlpha = alpha;
    return diffColor;
#endif
}

half LerpOneTo(half b, half t) { return lerp(1.0, b, t); }
half3 LerpWhiteTo(half3 b, half t) { return lerp(half3(1, 1, 1), b, t); }

half3 limn_ScaledNormalFromXY(half2 packedXY, half bumpScale)
{
    half2 xy = (packedXY * 2.0 - 1.0) * bumpScale;
    return half3(xy, sqrt(1.0 - saturate(dot(xy, xy))));
}
half3 UnpackScaleNormalDXT5nm(half4 packednormal, half bumpScale)
{
    return limn_ScaledNormalFromXY(packednormal.wy, bumpScale);
}
half3 UnpackScaleNormalRGorAG(half4 packednormal, half bumpScale)
{
    return limn_ScaledNormalFromXY(half2(packednormal.x * packednormal.w, packednormal.y), bumpScale);
}
half3 UnpackScaleNormal(half4 packednormal, half bumpScale)
{
    return UnpackScaleNormalRGorAG(packednormal, bumpScale);
}
half3 BlendNormals(half3 n1, half3 n2) { return normalize(half3(n1.xy + n2.xy, n1.z * n2.z)); }

// Rows: tangent, binormal, normal.
half3x3 CreateTangentToWorldPerVertex(half3 normal, half3 tangent, half tangentSign)
{
    half3 binormal = cross(normal, tangent) * (tangentSign * unity_WorldTransformParams.w);
    return half3x3(tangent, binormal, normal);
}

// Ambient light: order 2 per vertex and the rest per pixel, or all on one side, which
// UNITY_SAMPLE_FULL_SH_PER_PIXEL and the target choose.
half3 ShadeSHPerVertex(half3 normal, half3 ambient)
{
#if defined(UNITY_SAMPLE_FULL_SH_PER_PIXEL)
    return ambient;
#elif SHADER_TARGET < 30
    return ambient + max(half3(0, 0, 0), ShadeSH9(half4(normal, 1.0)));
#else
    return limn_LinearAmbient(ambient) + SHEvalLinearL2(half4(normal, 1.0));
#endif
}
half3 ShadeSHPerPixel(half3 normal, half3 ambient, float3 worldPos)
{
#if defined(UNITY_SAMPLE_FULL_SH_PER_PIXEL)
    return max(half3(0, 0, 0), ambient + ShadeSH9(half4(normal, 1.0)));
#elif SHADER_TARGET < 30
    return ambient;
#else
    half3 light = ambient + SHEvalLinearL0L1(half4(normal, 1.0));
    return limn_BuiltinAmbient(max(half3(0, 0, 0), light));
#endif
}

// Where a reflection seen from worldPos hits the box that the probe stands in.
half3 BoxProjectedCubemapDirection(half3 worldRefl, float3 worldPos, float4 cubemapCenter,
                                   float4 boxMin, float4 boxMax)
{
    UNITY_BRANCH
    if (cubemapCenter.w > 0.0)
    {
        half3 direction = normalize(worldRefl);
        half3 toMax = (boxMax.xyz - worldPos) / direction;
        half3 toMin = (boxMin.xyz - worldPos) / direction;
        half3 ahead = max(toMax, toMin); // of each pair of walls, the one in front
        half nearest = min(min(ahead.x, ahead.y), ahead.z);
        worldRefl = worldPos - cubemapCenter.xyz + direction * nearest;
    }
    return worldRefl;
}
#endif
