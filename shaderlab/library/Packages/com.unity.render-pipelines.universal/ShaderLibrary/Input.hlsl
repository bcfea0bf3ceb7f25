#pragma once
#ifndef UNIVERSAL_INPUT_INCLUDED
#define UNIVERSAL_INPUT_INCLUDED

#define MAX_VISIBLE_LIGHTS_UBO 32
#define MAX_VISIBLE_LIGHTS 32
#define MAX_ZBIN_VEC4S 1
#define URP_FP_DIRECTIONAL_LIGHTS_COUNT 0u

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/ShaderTypes.cs.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Deprecated.hlsl"

struct InputData
{
    float3 positionWS;
    float4 positionCS;
    float3 normalWS;
    float3 viewDirectionWS;
    float4 shadowCoord;
    float fogCoord;
    float3 vertexLighting;
    float3 bakedGI;
    float2 normalizedScreenSpaceUV;
    float4 shadowMask;
    float3x3 tangentToWorld;
};

struct VertexPositionInputs
{
    float3 positionWS;
    float3 positionVS;
    float4 positionCS;
    float4 positionNDC; // homogeneous: xy / w is the texture coordinate of the screen
};

struct VertexNormalInputs
{
    float3 tangentWS;
    float3 bitangentWS;
    float3 normalWS;
};

// Lights besides the main one. A scene has none until something sets these values.
cbuffer AdditionalLights
{
    float4 _AdditionalLightsCount; // x: of an object, at most
    float4 _AdditionalLightsPosition[MAX_VISIBLE_LIGHTS]; // w: 0 for a direction, 1 for a place
    float4 _AdditionalLightsColor[MAX_VISIBLE_LIGHTS];
    float4 _AdditionalLightsAttenuation[MAX_VISIBLE_LIGHTS]; // see GetAdditionalPerObjectLight
    float4 _AdditionalLightsSpotDir[MAX_VISIBLE_LIGHTS];
    float4 _AdditionalLightsOcclusionProbes[MAX_VISIBLE_LIGHTS];
    float4 _MainLightOcclusionProbes;
    float4 _AmbientOcclusionParam; // rgb: colour, w: how much direct light it takes
    float4 _GlossyEnvironmentColor;
    float4 _SubtractiveShadowColor;
    // As _AdditionalLightsPosition, places relative to limn_Origin
    float4 limn_AdditionalLightsPosition[MAX_VISIBLE_LIGHTS];
};

cbuffer limn_LightLayers
{
    uint _MainLightLayerMask; // the rendering layers that lights reach
    uint _AdditionalLightsLayerMasks[MAX_VISIBLE_LIGHTS];
};

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityInput.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/UnityInstancing.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/SpaceTransforms.hlsl"
#endif
