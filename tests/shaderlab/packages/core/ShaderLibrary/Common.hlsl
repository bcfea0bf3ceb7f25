// What files of Unity's core package are written with, in words of our own.
#ifndef UNITY_COMMON_INCLUDED
#define UNITY_COMMON_INCLUDED
#if defined(SHADER_API_MOBILE) || defined(SHADER_API_SWITCH)
#define HAS_HALF 1
#else
#define HAS_HALF 0
#endif
#ifndef PREFER_HALF
#define PREFER_HALF 1
#endif
#if HAS_HALF && PREFER_HALF
#define REAL_IS_HALF 1
#else
#define REAL_IS_HALF 0
#endif
#if REAL_IS_HALF
#define real half
#define real2 half2
#define real3 half3
#define real4 half4
#define real3x3 half3x3
#else
#define real float
#define real2 float2
#define real3 float3
#define real4 float4
#define real3x3 float3x3
#endif
#if defined(SHADER_API_VULKAN)
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/API/Vulkan.hlsl"
#else
#error unsupported shader api
#endif
#define FLT_SMALLEST 1.175494351e-38
#pragma warning (disable : 3205)
#define TEMPLATE_1_FLT(F, P, B) float F(float P) { B; } float2 F(float2 P) { B; } float3 F(float3 P) { B; } float4 F(float4 P) { B; }
#define TEMPLATE_1_FLT_HALF(F, P, B) TEMPLATE_1_FLT(F, P, B) half F(half P) { B; } half2 F(half2 P) { B; } half3 F(half3 P) { B; } half4 F(half4 P) { B; }
#define TEMPLATE_2_INT(F, P, Q, B) int F(int P, int Q) { B; } int2 F(int2 P, int2 Q) { B; } uint F(uint P, uint Q) { B; }
#define TEMPLATE_SWAP(F) void F(inout real a, inout real b) { real t = a; a = b; b = t; } void F(inout uint2 a, inout uint2 b) { uint2 t = a; a = b; b = t; }
TEMPLATE_1_FLT_HALF(Square, x, return x * x)
TEMPLATE_1_FLT_HALF(SafeRoot, x, return sqrt(max(0, x)))
TEMPLATE_2_INT(DivideUp, a, b, return (a + b - 1) / b)
TEMPLATE_SWAP(Swap)
half Smallest3(half3 v) { return min(v.x, min(v.y, v.z)); }
float Smallest3(float3 v) { return min(v.x, min(v.y, v.z)); }
real3 Unpack(real4 packed, real scale = 1.0) { real3 n; n.xy = packed.ag * 2.0 - 1.0; n.z = max(1.0e-16, sqrt(1.0 - saturate(dot(n.xy, n.xy)))); n.xy *= scale; return n; }
float3 Normalized(float3 v) { float d = max(FLT_SMALLEST, dot(v, v)); return v * rsqrt(d); }
static const float4x4 k_Identity = {1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1};
static const float2 k_Poisson[4] = { float2(-0.94, -0.39), float2(0.94, -0.76), float2(-0.09, -0.92), float2(0.34, 0.29) };
real3x3 TangentToWorld(real3 n, real4 t) { real3 b = cross(n, t.xyz) * (t.w > 0.0 ? 1.0 : -1.0); return real3x3(t.xyz, b, n); }
bool IsNaN_(float x) { return (asuint(x) & 0x7fffffff) > 0x7f800000; }
float PositivePow_(float b, float p) { return pow(max(abs(b), float(FLT_SMALLEST)), p); }
void LerpAll(inout half4 c, half4 d, half t) { c = lerp(c, d, t); }
struct PositionInputs { float3 positionWS; uint2 positionSS; float2 positionNDC; };
PositionInputs GetInputs(float2 p, float2 inv, uint2 tile) { PositionInputs o; ZERO_INITIALIZE(PositionInputs, o); o.positionNDC = p; o.positionNDC *= inv; o.positionSS = uint2(p); return o; }
PositionInputs GetInputs(float2 p, float2 inv) { return GetInputs(p, inv, uint2(0, 0)); }
#endif
