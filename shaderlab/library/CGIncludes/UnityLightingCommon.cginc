#pragma once
#ifndef UNITY_LIGHTING_COMMON_INCLUDED
#define UNITY_LIGHTING_COMMON_INCLUDED
#include "UnityShaderVariables.cginc"

// By these names the pipeline and the material give them.
fixed4 _LightColor0;
fixed4 _SpecColor;

struct UnityLight
{
    half3 color;
    half3 dir; // to the light
    half ndotl;
};

struct UnityIndirect
{
    half3 diffuse;
    half3 specular;
};

struct UnityGI
{
    UnityLight light;
    UnityIndirect indirect;
};

struct UnityGIInput
{
    UnityLight light;
    float3 worldPos;
    half3 worldViewDir;
    half atten;
    half3 ambient;
    float4 lightmapUV; // xy: static, zw: dynamic light map
    float4 boxMin[2];
    float4 boxMax[2];
    float4 probePosition[2];
    float4 probeHDR[2];
};
#endif
