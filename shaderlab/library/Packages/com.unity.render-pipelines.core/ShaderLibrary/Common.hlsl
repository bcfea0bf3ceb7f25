#pragma once

// float on every platform limn draws on.
#define REAL_IS_HALF 0
#define real float
#define real2 float2
#define real3 float3
#define real4 float4
#define real2x2 float2x2
#define real3x3 float3x3
#define real3x4 float3x4
#define real4x3 float4x3
#define real4x4 float4x4
#define REAL_MIN FLT_MIN
#define REAL_MAX FLT_MAX
#define REAL_EPS FLT_EPSILON

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/API/Vulkan.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Macros.hlsl"

float Sq(float x) { return x * x; }
float2 Sq(float2 x) { return x * x; }
float3 Sq(float3 x) { return x * x; }
float4 Sq(float4 x) { return x * x; }
float Pow4(float x) { return Sq(Sq(x)); }

float Min3(float a, float b, float c) { return min(a, min(b, c)); }
float2 Min3(float2 a, float2 b, float2 c) { return min(a, min(b, c)); }
float3 Min3(float3 a, float3 b, float3 c) { return min(a, min(b, c)); }
float4 Min3(float4 a, float4 b, float4 c) { return min(a, min(b, c)); }
float Max3(float a, float b, float c) { return max(a, max(b, c)); }
float2 Max3(float2 a, float2 b, float2 c) { return max(a, max(b, c)); }
float3 Max3(float3 a, float3 b, float3 c) { return max(a, max(b, c)); }
float4 Max3(float4 a, float4 b, float4 c) { return max(a, max(b, c)); }

// pow of a base that rounding may have made negative.
float PositivePow(float base, float power) { return pow(abs(base), power); }
float2 PositivePow(float2 base, float2 power) { return pow(abs(base), power); }
float3 PositivePow(float3 base, float3 power) { return pow(abs(base), power); }
float4 PositivePow(float4 base, float4 power) { return pow(abs(base), power); }
float SafePositivePow(float base, float power) { return pow(max(abs(base), FLT_EPSILON), power); }

float Remap01(float x, float scale, float offset) { return saturate(x * scale + offset); }
float3 LerpWhiteTo(float3 b, float t) { return lerp(float3(1, 1, 1), b, t); }

// The zero vector stays zero.
float3 SafeNormalize(float3 v) { return v * rsqrt(max(FLT_MIN, dot(v, v))); }
float SafeDiv(float a, float b) { return a != b ? a / b : 1; }

float2 RotateByAngle(float2 v, float angle)
{
    float s = sin(angle);
    float c = cos(angle);
    return float2(v.x * c - v.y * s, v.x * s + v.y * c);
}

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Depth.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/FullScreen.hlsl"
