// What files of Unity's universal package are written with, in words of our own.
#ifndef UNIVERSAL_PIPELINE_CORE_INCLUDED
#define UNIVERSAL_PIPELINE_CORE_INCLUDED
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
CBUFFER_START(UnityPerDraw)
float4x4 unity_ObjectToWorld;
float4 unity_LODFade;
half4 unity_LightData;
half4 unity_LightIndices[2];
real4 unity_SHAr;
CBUFFER_END
float4x4 unity_MatrixVP;
TEXTURE2D_HALF(_Small); SAMPLER(sampler_Small); TEXTURE2D_FLOAT(_Large); TEXTURECUBE_HALF(_Sky);
#if defined(SHADER_API_VULKAN)
StructuredBuffer<float4> _Lights;
#endif
half4 SampleSmall(float2 uv, TEXTURE2D_PARAM(map, sampler_map)) { return half4(SAMPLE_TEXTURE2D(map, sampler_map, uv)); }
half Attenuation(float distanceSqr, half2 fade) { float light = rcp(distanceSqr); float2 f = float2(fade); half s = half(distanceSqr * f.x); s = saturate(half(1.0) - s * s); return light * s * s; }
float Attenuation(float distanceSqr, float2 fade) { return distanceSqr * fade.y; }
half3 Shade(half3 n) { half4 v = half4(n, 1.0); half3 c = (half3)0; [unroll] for (uint i = 0u; i < 2u; ++i) { c += half3(unity_LightIndices[i].xyz) * v.w; } return c + SafeRoot(n) + Square(n.x); }
float4 ToClip(float3 p) { return mul(unity_MatrixVP, mul(unity_ObjectToWorld, float4(p, 1.0))); }
#endif
