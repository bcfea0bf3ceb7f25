#pragma once
#ifndef UNITY_COMMON_INCLUDED
#define UNITY_COMMON_INCLUDED

// float on every platform limn draws on.
#define REAL_IS_HALF 0
#define HAS_HALF 0
#define real float
#define real1 float1
#define real2 float2
#define real3 float3
#define real4 float4
#define real2x2 float2x2
#define real2x3 float2x3
#define real2x4 float2x4
#define real3x2 float3x2
#define real3x3 float3x3
#define real3x4 float3x4
#define real4x3 float4x3
#define real4x4 float4x4
#define REAL_MIN FLT_MIN
#define REAL_MAX FLT_MAX
#define REAL_EPS FLT_EPSILON
#define min16float float
#define min16float2 float2
#define min16float3 float3
#define min16float4 float4

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/API/Vulkan.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Macros.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMath.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Random.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Depth.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/FullScreen.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonTexture.hlsl"
#endif
