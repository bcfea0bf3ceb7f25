// Comes before every program: what Unity's compiler defines by itself.
#pragma once

#define SHADER_API_VULKAN 1
#define SHADER_API_DESKTOP 1
#define UNITY_VERSION 202230
#define UNITY_COMPILER_HLSL 1

// As on Unity's desktop targets, half is float. Macros rather than the compiler's own half, which
// marks values as low precision and lets a driver compute them with fewer bits.
#define half float
#define half1 float1
#define half2 float2
#define half3 float3
#define half4 float4
#define half2x2 float2x2
#define half3x3 float3x3
#define half3x4 float3x4
#define half4x3 float4x3
#define half4x4 float4x4
