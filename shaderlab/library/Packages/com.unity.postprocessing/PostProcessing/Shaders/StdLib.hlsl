// What effects of the Post-processing Stack v2 call.
#pragma once

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/API/Vulkan.hlsl"
#include "Packages/com.unity.postprocessing/PostProcessing/Shaders/xRLib.hlsl"
#include "limn/Globals.hlsl"
#include "limn/Screen.hlsl"

#define HALF_MAX 65504.0
#define HALF_MAX_MINUS1 65472.0
#define EPSILON 1.0e-4
#define PI 3.14159265359
#define TWO_PI 6.28318530718
#define FOUR_PI 12.56637061436
#define INV_PI 0.31830988618
#define INV_TWO_PI 0.15915494309
#define INV_FOUR_PI 0.07957747155
#define HALF_PI 1.57079632679
#define INV_HALF_PI 0.636619772367
#define FLT_EPSILON 1.192092896e-07
#define FLT_MIN 1.175494351e-38
#define FLT_MAX 3.402823466e+38

#define TEXTURE2D_SAMPLER2D(textureName, samplerName) \
    Texture2D textureName; \
    SamplerState samplerName
#define TEXTURE3D_SAMPLER3D(textureName, samplerName) \
    Texture3D textureName; \
    SamplerState samplerName

float Min3(float a, float b, float c) { return min(a, min(b, c)); }
float2 Min3(float2 a, float2 b, float2 c) { return min(a, min(b, c)); }
float3 Min3(float3 a, float3 b, float3 c) { return min(a, min(b, c)); }
float4 Min3(float4 a, float4 b, float4 c) { return min(a, min(b, c)); }
float Max3(float a, float b, float c) { return max(a, max(b, c)); }
float2 Max3(float2 a, float2 b, float2 c) { return max(a, max(b, c)); }
float3 Max3(float3 a, float3 b, float3 c) { return max(a, max(b, c)); }
float4 Max3(float4 a, float4 b, float4 c) { return max(a, max(b, c)); }
float Pow2(float x) { return x * x; }
float Pow3(float x) { return x * x * x; }
float Pow4(float x) { return x * x * x * x; }
float FastSign(float x) { return saturate(x * FLT_MAX + 0.5) * 2.0 - 1.0; }
float2 FastSign(float2 x) { return saturate(x * FLT_MAX + 0.5) * 2.0 - 1.0; }
float3 FastSign(float3 x) { return saturate(x * FLT_MAX + 0.5) * 2.0 - 1.0; }

// pow of a base that rounding may have made negative.
float PositivePow(float base, float power) { return pow(max(abs(base), FLT_EPSILON), power); }
float2 PositivePow(float2 base, float2 power) { return pow(max(abs(base), FLT_EPSILON), power); }
float3 PositivePow(float3 base, float3 power) { return pow(max(abs(base), FLT_EPSILON), power); }
float4 PositivePow(float4 base, float4 power) { return pow(max(abs(base), FLT_EPSILON), power); }

bool IsNan(float x) { return (asuint(x) & 0x7FFFFFFFu) > 0x7F800000u; }
bool AnyIsNan(float2 x) { return IsNan(x.x) || IsNan(x.y); }
bool AnyIsNan(float3 x) { return IsNan(x.x) || IsNan(x.y) || IsNan(x.z); }
bool AnyIsNan(float4 x) { return AnyIsNan(x.xyz) || IsNan(x.w); }

// What a half float can hold.
float4 SafeHDR(float4 c) { return min(c, HALF_MAX); }
float3 SafeHDR(float3 c) { return min(c, HALF_MAX); }
float2 SafeHDR(float2 c) { return min(c, HALF_MAX); }
float SafeHDR(float c) { return min(c, HALF_MAX); }

// Depth, and distance along the view axis as a part of the far plane's or in metres; perspective or
// orthographic.
float Linear01Depth(float z)
{
    return unity_OrthoParams.w > 0.0 ? 1.0 - limn_Nearness(z)
                                   : limn_Linear01Depth(z, _ZBufferParams);
}
float LinearEyeDepth(float z) { return limn_LinearEyeDepth(z, _ZBufferParams); }

// Rec. 709 weights, linear colours
float Luminance(float3 linearRgb)
{
    return dot(linearRgb, float3(0.2126729, 0.7151522, 0.0721750));
}
float Luminance(float4 linearRgba) { return Luminance(linearRgba.rgb); }

// One triangle over the target; corners at -1 and 3.
float2 TransformTriangleVertexToUV(float2 vertex) { return (vertex + 1.0) * 0.5; }

struct AttributesDefault
{
    float3 vertex : POSITION;
};

struct VaryingsDefault
{
    float4 vertex : SV_POSITION;
    float2 texcoord : TEXCOORD0;
    float2 texcoordStereo : TEXCOORD1;
};

float4 _UVTransform; // scale, offset

VaryingsDefault VertDefault(AttributesDefault v)
{
    VaryingsDefault o;
    o.vertex = float4(v.vertex.xy, 0.0, 1.0);
    float2 uv = TransformTriangleVertexToUV(v.vertex.xy);
    o.texcoord = float2(uv.x, 1.0 - uv.y);
    o.texcoordStereo = TransformStereoScreenSpaceTex(o.texcoord, 1.0);
    return o;
}
VaryingsDefault VertUVTransform(AttributesDefault v)
{
    VaryingsDefault o;
    o.vertex = float4(v.vertex.xy, 0.0, 1.0);
    o.texcoord = TransformTriangleVertexToUV(v.vertex.xy) * _UVTransform.xy + _UVTransform.zw;
    o.texcoordStereo = TransformStereoScreenSpaceTex(o.texcoord, 1.0);
    return o;
}
