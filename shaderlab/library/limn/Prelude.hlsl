// Comes before every program, behind the macros that Unity's compiler defines by itself
// (k_PredefinedMacros).
#pragma once

// As on Unity's desktop targets, half is float. Macros rather than the compiler's own half, which
// marks values as low precision and lets a driver compute them with fewer bits. With
// ShaderCompilerOptions::halfIs16Bit what is marked becomes 16 bits; matrices do not.
#if defined(LIMN_REAL_HALF)
#define half min16float
#define half1 min16float1
#define half2 min16float2
#define half3 min16float3
#define half4 min16float4
#else
#define half float
#define half1 float1
#define half2 float2
#define half3 float3
#define half4 float4
#endif
#define half2x2 float2x2
#define half3x3 float3x3
#define half3x4 float3x4
#define half4x3 float4x3
#define half4x4 float4x4

// limn::DrawConstants; the generated entry functions read them.
[[vk::push_constant]] cbuffer limn_PushConstants
{
    uint limn_FirstInstance;
    uint limn_InstanceBase;
};
