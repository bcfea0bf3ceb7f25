#pragma once
#ifndef UNIVERSAL_LIGHTING_INCLUDED
#define UNIVERSAL_LIGHTING_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/BRDF.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Debug/Debugging3D.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/GlobalIllumination.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/RealtimeLights.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/AmbientOcclusion.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DBuffer.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceData.hlsl"

// Light by where it comes from, until it is summed up.
struct LightingData
{
    float3 giColor;
    float3 mainLightColor;
    float3 additionalLightsColor;
    float3 vertexLightingColor;
    float3 emissionColor;
};

float3 LightingLambert(float3 lightColor, float3 lightDir, float3 normal)
{
    return lightColor * saturate(dot(normal, lightDir));
}

// Blinn-Phong; smoothness is the exponent.
float3 LightingSpecular(float3 lightColor, float3 lightDir, float3 normal, float3 viewDir,
                        float4 specular, float smoothness)
{
    float3 halfway = SafeNormalize(lightDir + viewDir);
    return lightColor * specular.rgb * pow(saturate(dot(normal, halfway)), smoothness);
}

float3 LightingPhysicallyBased(BRDFData brdfData, BRDFData brdfDataClearCoat, float3 lightColor,
                               float3 lightDirectionWS, float lightAttenuation, float3 normalWS,
                               float3 viewDirectionWS, float clearCoatMask,
                               bool specularHighlightsOff)
{
    float3 radiance = lightColor * (lightAttenuation * saturate(dot(normalWS, lightDirectionWS)));
    float3 brdf = DirectBDRF(brdfData, normalWS, lightDirectionWS, viewDirectionWS,
                             specularHighlightsOff);
#if defined(_CLEARCOAT) || defined(_CLEARCOATMAP)
    float coat = specularHighlightsOff ? 0.0
                                       : kDielectricSpec.r *
                                             DirectBRDFSpecular(brdfDataClearCoat, normalWS,
                                                                lightDirectionWS, viewDirectionWS);
    float fresnel = F_Schlick(kDielectricSpec.x, saturate(dot(normalWS, viewDirectionWS)));
    brdf = brdf * (1.0 - clearCoatMask * fresnel) + coat * clearCoatMask;
#endif
    return brdf * radiance;
}
float3 LightingPhysicallyBased(BRDFData brdfData, BRDFData brdfDataClearCoat, Light light,
                               float3 normalWS, float3 viewDirectionWS, float clearCoatMask,
                               bool specularHighlightsOff)
{
    float attenuation = light.shadowAttenuation * light.distanceAttenuation;
    return LightingPhysicallyBased(brdfData, brdfDataClearCoat, light.color, light.direction,
                                   attenuation, normalWS, viewDirectionWS, clearCoatMask,
                                   specularHighlightsOff);
}
float3 LightingPhysicallyBased(BRDFData brdfData, Light light, float3 normalWS,
                               float3 viewDirectionWS, bool specularHighlightsOff)
{
    return LightingPhysicallyBased(brdfData, (BRDFData)0, light, normalWS, viewDirectionWS, 0.0,
                                   specularHighlightsOff);
}
float3 LightingPhysicallyBased(BRDFData brdfData, Light light, float3 normalWS,
                               float3 viewDirectionWS)
{
#ifdef _SPECULARHIGHLIGHTS_OFF
    return LightingPhysicallyBased(brdfData, light, normalWS, viewDirectionWS, true);
#else
    return LightingPhysicallyBased(brdfData, light, normalWS, viewDirectionWS, false);
#endif
}
float3 LightingPhysicallyBased(BRDFData brdfData, float3 lightColor, float3 lightDirectionWS,
                               float lightAttenuation, float3 normalWS, float3 viewDirectionWS)
{
    return LightingPhysicallyBased(brdfData, (BRDFData)0, lightColor, lightDirectionWS,
                                   lightAttenuation, normalWS, viewDirectionWS, 0.0, false);
}

// Lambert of the lights besides the main one, for _ADDITIONAL_LIGHTS_VERTEX.
float3 VertexLighting(float3 positionWS, float3 normalWS)
{
    float3 sum = float3(0, 0, 0);
#ifdef _ADDITIONAL_LIGHTS_VERTEX
    uint count = (uint)GetAdditionalLightsCount();
    for (uint i = 0u; i < count; ++i)
    {
        Light light = GetAdditionalLight(i, positionWS);
        sum += LightingLambert(light.color * light.distanceAttenuation, light.direction, normalWS);
    }
#endif
    return sum;
}

LightingData CreateLightingData(InputData inputData, SurfaceData surfaceData)
{
    LightingData lightingData = (LightingData)0;
    lightingData.giColor = inputData.bakedGI;
    lightingData.emissionColor = surfaceData.emission;
    return lightingData;
}
float3 CalculateLightingColor(LightingData lightingData, float3 albedo)
{
    float3 light = lightingData.giColor + lightingData.mainLightColor +
                   lightingData.additionalLightsColor + lightingData.vertexLightingColor;
    return light * albedo + lightingData.emissionColor;
}
float4 CalculateFinalColor(LightingData lightingData, float alpha)
{
    return float4(CalculateLightingColor(lightingData, float3(1, 1, 1)), alpha);
}
float4 CalculateFinalColor(LightingData lightingData, float3 albedo, float alpha, float fogCoord)
{
    return float4(MixFog(CalculateLightingColor(lightingData, albedo), fogCoord), alpha);
}

float3 CalculateBlinnPhong(Light light, InputData inputData, SurfaceData surfaceData)
{
    float3 arriving = light.color * (light.distanceAttenuation * light.shadowAttenuation);
    float3 color =
        LightingLambert(arriving, light.direction, inputData.normalWS) * surfaceData.albedo;
#ifdef _ALPHAPREMULTIPLY_ON
    color *= surfaceData.alpha; // a highlight lies on the surface, however clear that is
#endif
#if defined(_SPECGLOSSMAP) || defined(_SPECULAR_COLOR)
    float exponent = exp2(10.0 * surfaceData.smoothness + 1.0);
    float4 specular = float4(surfaceData.specular, 1.0);
    color += LightingSpecular(arriving, light.direction, inputData.normalWS,
                              inputData.viewDirectionWS, specular, exponent);
#endif
    return color;
}

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/FragmentLighting.hlsl"
#endif
