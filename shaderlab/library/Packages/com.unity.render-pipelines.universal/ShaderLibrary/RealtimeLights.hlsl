#pragma once

struct Light
{
    float3 direction; // to the light
    float3 color;
    float distanceAttenuation;
    float shadowAttenuation;
    uint layerMask;
};

Light GetMainLight()
{
    Light light;
    light.direction = _MainLightPosition.xyz;
    light.color = _MainLightColor.rgb;
    light.distanceAttenuation = 1.0;
    light.shadowAttenuation = 1.0;
    light.layerMask = 0xFFFFFFFFu;
    return light;
}

// There are no shadow maps.
Light GetMainLight(float4 shadowCoord) { return GetMainLight(); }
Light GetMainLight(float4 shadowCoord, float3 positionWS, float4 shadowMask) { return GetMainLight(); }
float4 TransformWorldToShadowCoord(float3 positionWS) { return float4(0, 0, 0, 0); }
float4 GetShadowCoord(VertexPositionInputs vertexInput) { return float4(0, 0, 0, 0); }

int GetAdditionalLightsCount() { return 0; }
Light GetAdditionalLight(uint index, float3 positionWS)
{
    Light light = GetMainLight();
    light.color = float3(0, 0, 0);
    return light;
}

bool IsMatchingLightLayer(uint lightLayers, uint renderingLayers)
{
    return (lightLayers & renderingLayers) != 0;
}
