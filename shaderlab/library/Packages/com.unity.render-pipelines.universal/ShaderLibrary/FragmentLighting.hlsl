// The lighting models as a whole.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"

#if defined(_LIGHT_LAYERS)
#define limn_LightReaches(light, layers) IsMatchingLightLayer((light).layerMask, layers)
#else
#define limn_LightReaches(light, layers) true
#endif

// Physically based: BRDF.hlsl.
float4 UniversalFragmentPBR(InputData inputData, SurfaceData surfaceData)
{
#ifdef _SPECULARHIGHLIGHTS_OFF
    bool specularHighlightsOff = true;
#else
    bool specularHighlightsOff = false;
#endif
    BRDFData brdfData;
    InitializeBRDFData(surfaceData, brdfData);
    BRDFData coat = CreateClearCoatBRDFData(surfaceData, brdfData);
    float4 shadowMask = CalculateShadowMask(inputData);
    AmbientOcclusionFactor occlusion = CreateAmbientOcclusionFactor(inputData, surfaceData);
    uint layers = GetMeshRenderingLayer();
    Light mainLight = GetMainLight(inputData, shadowMask, occlusion);

    LightingData lightingData = CreateLightingData(inputData, surfaceData);
#ifdef _ADDITIONAL_LIGHTS_VERTEX
    lightingData.vertexLightingColor += inputData.vertexLighting * brdfData.diffuse;
#endif
    lightingData.giColor = GlobalIllumination(
        brdfData, coat, surfaceData.clearCoatMask, inputData.bakedGI,
        occlusion.indirectAmbientOcclusion, inputData.positionWS, inputData.normalWS,
        inputData.viewDirectionWS, inputData.normalizedScreenSpaceUV);
    if (limn_LightReaches(mainLight, layers))
    {
        lightingData.mainLightColor = LightingPhysicallyBased(
            brdfData, coat, mainLight, inputData.normalWS, inputData.viewDirectionWS,
            surfaceData.clearCoatMask, specularHighlightsOff);
    }
#ifdef _ADDITIONAL_LIGHTS
    LIGHT_LOOP_BEGIN(GetAdditionalLightsCount())
        Light light = GetAdditionalLight(lightIndex, inputData, shadowMask, occlusion);
        if (limn_LightReaches(light, layers))
        {
            lightingData.additionalLightsColor += LightingPhysicallyBased(
                brdfData, coat, light, inputData.normalWS, inputData.viewDirectionWS,
                surfaceData.clearCoatMask, specularHighlightsOff);
        }
    LIGHT_LOOP_END
#endif
    return CalculateFinalColor(lightingData, surfaceData.alpha);
}
float4 UniversalFragmentPBR(InputData inputData, float3 albedo, float metallic, float3 specular,
                            float smoothness, float occlusion, float3 emission, float alpha)
{
    SurfaceData surface = (SurfaceData)0; // without a coat
    surface.clearCoatSmoothness = 1.0;
    surface.normalTS = float3(0, 0, 1);
    surface.alpha = alpha;
    surface.albedo = albedo;
    surface.emission = emission;
    surface.occlusion = occlusion;
    surface.smoothness = smoothness;
    surface.metallic = metallic;
    surface.specular = specular;
    return UniversalFragmentPBR(inputData, surface);
}

// Lambert, and Blinn-Phong where _SPECGLOSSMAP or _SPECULAR_COLOR is set.
float4 UniversalFragmentBlinnPhong(InputData inputData, SurfaceData surfaceData)
{
    float4 shadowMask = CalculateShadowMask(inputData);
    AmbientOcclusionFactor occlusion = CreateAmbientOcclusionFactor(inputData, surfaceData);
    uint layers = GetMeshRenderingLayer();
    Light mainLight = GetMainLight(inputData, shadowMask, occlusion);

    inputData.bakedGI *= occlusion.indirectAmbientOcclusion * surfaceData.albedo;
    LightingData lightingData = CreateLightingData(inputData, surfaceData);
#ifdef _ADDITIONAL_LIGHTS_VERTEX
    lightingData.vertexLightingColor += inputData.vertexLighting * surfaceData.albedo;
#endif
    if (limn_LightReaches(mainLight, layers))
    {
        lightingData.mainLightColor = CalculateBlinnPhong(mainLight, inputData, surfaceData);
    }
#ifdef _ADDITIONAL_LIGHTS
    LIGHT_LOOP_BEGIN(GetAdditionalLightsCount())
        Light light = GetAdditionalLight(lightIndex, inputData, shadowMask, occlusion);
        if (limn_LightReaches(light, layers))
        {
            lightingData.additionalLightsColor +=
                CalculateBlinnPhong(light, inputData, surfaceData);
        }
    LIGHT_LOOP_END
#endif
    return CalculateFinalColor(lightingData, surfaceData.alpha);
}
float4 UniversalFragmentBlinnPhong(InputData inputData, float3 diffuse, float4 specularGloss,
                                   float smoothness, float3 emission, float alpha, float3 normalTS)
{
    SurfaceData surfaceData = (SurfaceData)0;
    surfaceData.albedo = diffuse;
    surfaceData.specular = specularGloss.rgb;
    surfaceData.smoothness = smoothness;
    surfaceData.normalTS = normalTS;
    surfaceData.emission = emission;
    surfaceData.occlusion = 1.0;
    surfaceData.alpha = alpha;
    surfaceData.clearCoatSmoothness = 1.0;
    return UniversalFragmentBlinnPhong(inputData, surfaceData);
}
float4 UniversalFragmentBlinnPhong(InputData inputData, float3 diffuse, float4 specularGloss,
                                   float smoothness, float3 emission, float alpha)
{
    return UniversalFragmentBlinnPhong(inputData, diffuse, specularGloss, smoothness, emission,
                                       alpha, float3(0, 0, 1));
}

// Ambient light alone.
float4 UniversalFragmentBakedLit(InputData inputData, SurfaceData surfaceData)
{
    AmbientOcclusionFactor occlusion = CreateAmbientOcclusionFactor(inputData, surfaceData);
    LightingData lightingData = CreateLightingData(inputData, surfaceData);
    lightingData.giColor *= occlusion.indirectAmbientOcclusion * surfaceData.albedo;
    return CalculateFinalColor(lightingData, surfaceData.alpha);
}
float4 UniversalFragmentBakedLit(InputData inputData, float3 color, float alpha, float3 normalTS)
{
    SurfaceData surfaceData = (SurfaceData)0;
    surfaceData.albedo = color;
    surfaceData.alpha = alpha;
    surfaceData.normalTS = normalTS;
    surfaceData.occlusion = 1.0;
    return UniversalFragmentBakedLit(inputData, surfaceData);
}
