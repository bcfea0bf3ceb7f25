#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceData.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/RealtimeLights.hlsl"

// Ambient light, which comes from all sides alike.
float3 SampleSH(float3 normalWS) { return unity_AmbientSky.rgb; }
float3 SampleSHVertex(float3 normalWS) { return float3(0, 0, 0); }
float3 SampleSHPixel(float3 vertexSH, float3 normalWS) { return SampleSH(normalWS); }

float3 LightingLambert(float3 lightColor, float3 lightDir, float3 normal)
{
    return lightColor * saturate(dot(normal, lightDir));
}

float3 LightingSpecular(float3 lightColor, float3 lightDir, float3 normal, float3 viewDir,
                        float4 specular, float smoothness)
{
    float3 halfway = SafeNormalize(lightDir + viewDir);
    return lightColor * specular.rgb * pow(saturate(dot(normal, halfway)), smoothness);
}

float3 VertexLighting(float3 positionWS, float3 normalWS) { return float3(0, 0, 0); }

// Lambert and Blinn-Phong with the main light and ambient light.
float4 UniversalFragmentBlinnPhong(InputData inputData, SurfaceData surfaceData)
{
    Light light = GetMainLight();
    float3 diffuse = inputData.bakedGI + inputData.vertexLighting +
                     LightingLambert(light.color, light.direction, inputData.normalWS);
    float3 specular = LightingSpecular(light.color, light.direction, inputData.normalWS,
                                       inputData.viewDirectionWS, float4(surfaceData.specular, 1),
                                       exp2(10.0 * surfaceData.smoothness + 1.0));
    return float4(diffuse * surfaceData.albedo + specular + surfaceData.emission, surfaceData.alpha);
}
