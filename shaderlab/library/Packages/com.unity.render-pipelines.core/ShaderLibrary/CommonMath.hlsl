// Small functions of numbers that the rest of the library and many shaders use.
#pragma once

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Macros.hlsl"

float DegToRad(float degrees) { return degrees * (PI / 180.0); }
float RadToDeg(float angle) { return angle * (180.0 / PI); }

float Sq(float x) { return x * x; }
float2 Sq(float2 x) { return x * x; }
float3 Sq(float3 x) { return x * x; }
float4 Sq(float4 x) { return x * x; }
float Pow4(float x) { return Sq(Sq(x)); }
float2 Pow4(float2 x) { return Sq(Sq(x)); }
float3 Pow4(float3 x) { return Sq(Sq(x)); }
float4 Pow4(float4 x) { return Sq(Sq(x)); }

float Min3(float a, float b, float c) { return min(a, min(b, c)); }
float2 Min3(float2 a, float2 b, float2 c) { return min(a, min(b, c)); }
float3 Min3(float3 a, float3 b, float3 c) { return min(a, min(b, c)); }
float4 Min3(float4 a, float4 b, float4 c) { return min(a, min(b, c)); }
int Min3(int a, int b, int c) { return min(a, min(b, c)); }
float Max3(float a, float b, float c) { return max(a, max(b, c)); }
float2 Max3(float2 a, float2 b, float2 c) { return max(a, max(b, c)); }
float3 Max3(float3 a, float3 b, float3 c) { return max(a, max(b, c)); }
float4 Max3(float4 a, float4 b, float4 c) { return max(a, max(b, c)); }
int Max3(int a, int b, int c) { return max(a, max(b, c)); }
float Avg3(float a, float b, float c) { return (a + b + c) / 3.0; }

// pow of a base that rounding may have made negative.
float PositivePow(float base, float power) { return pow(abs(base), power); }
float2 PositivePow(float2 base, float2 power) { return pow(abs(base), power); }
float3 PositivePow(float3 base, float3 power) { return pow(abs(base), power); }
float4 PositivePow(float4 base, float4 power) { return pow(abs(base), power); }
float SafePositivePow(float base, float power) { return pow(max(abs(base), FLT_EPSILON), power); }
float2 SafePositivePow(float2 base, float2 power)
{
    return pow(max(abs(base), FLT_EPSILON.xx), power);
}
float3 SafePositivePow(float3 base, float3 power)
{
    return pow(max(abs(base), FLT_EPSILON.xxx), power);
}
float4 SafePositivePow(float4 base, float4 power)
{
    return pow(max(abs(base), FLT_EPSILON.xxxx), power);
}

float SafeSqrt(float x) { return sqrt(max(x, 0.0)); }
// The zero vector stays zero.
float3 SafeNormalize(float3 v) { return v * rsqrt(max(FLT_MIN, dot(v, v))); }
// 1 where both are the same, 0/0 too.
float SafeDiv(float a, float b) { return a != b ? a / b : 1; }
float SinFromCos(float cosine) { return SafeSqrt(1.0 - cosine * cosine); }

// 0 at start and below, 1 at start + 1/scale and above; Remap10 the other way round.
float Remap01(float x, float scale, float offset) { return saturate(x * scale + offset); }
float2 Remap01(float2 x, float2 scale, float2 offset) { return saturate(x * scale + offset); }
float3 Remap01(float3 x, float3 scale, float3 offset) { return saturate(x * scale + offset); }
float Remap10(float x, float scale, float offset) { return saturate(offset - x * scale); }
float Smoothstep01(float x) { return x * x * (3.0 - 2.0 * x); }
float Smootherstep01(float x) { return x * x * x * (x * (x * 6.0 - 15.0) + 10.0); }
float Smootherstep(float a, float b, float t)
{
    return Smootherstep01(saturate((t - a) / (b - a)));
}

float LerpWhiteTo(float b, float t) { return 1.0 + t * (b - 1.0); }
float3 LerpWhiteTo(float3 b, float t) { return 1.0 + t * (b - 1.0); }
float3 NLerp(float3 a, float3 b, float t) { return normalize(lerp(a, b, t)); }
float Length2(float3 v) { return dot(v, v); }

// The second with the sign of the first; without a sign of zero.
float CopySign(float x, float s) { return s >= 0.0 ? abs(x) : -abs(x); }
float FastMulBySignOf(float s, float x) { return s >= 0.0 ? x : -x; }
float FastSign(float s) { return s >= 0.0 ? 1.0 : -1.0; }

// The compiler's own, which are exact: these names promise speed, not an error.
float FastACosPos(float x) { return acos(saturate(x)); }
float FastACos(float x) { return acos(clamp(x, -1.0, 1.0)); }
float FastASin(float x) { return asin(clamp(x, -1.0, 1.0)); }
float FastATanPos(float x) { return atan(x); }
float FastATan(float x) { return atan(x); }
float FastAtan2(float y, float x) { return atan2(y, x); }

// Floor of the logarithm of base 2.
uint FastLog2(uint x) { return firstbithigh(x); }
bool IsPower2(uint x) { return (x & (x - 1)) == 0; }

bool IsNaN(float x) { return (asuint(x) & 0x7FFFFFFFu) > 0x7F800000u; }
bool AnyIsNaN(float2 v) { return IsNaN(v.x) || IsNaN(v.y); }
bool AnyIsNaN(float3 v) { return IsNaN(v.x) || IsNaN(v.y) || IsNaN(v.z); }
bool AnyIsNaN(float4 v) { return AnyIsNaN(v.xy) || AnyIsNaN(v.zw); }
bool IsInf(float x) { return (asuint(x) & 0x7FFFFFFFu) == 0x7F800000u; }
bool AnyIsInf(float2 v) { return IsInf(v.x) || IsInf(v.y); }
bool AnyIsInf(float3 v) { return IsInf(v.x) || IsInf(v.y) || IsInf(v.z); }
bool AnyIsInf(float4 v) { return AnyIsInf(v.xy) || AnyIsInf(v.zw); }
bool IsFinite(float x) { return (asuint(x) & 0x7F800000u) != 0x7F800000u; }
float SanitizeFinite(float x) { return IsFinite(x) ? x : 0.0; }

float ClampToFloat16Max(float value) { return min(value, HALF_MAX); }
float2 ClampToFloat16Max(float2 value) { return min(value, HALF_MAX); }
float3 ClampToFloat16Max(float3 value) { return min(value, HALF_MAX); }
float4 ClampToFloat16Max(float4 value) { return min(value, HALF_MAX); }

// Bits of integers.
uint BitFieldExtract(uint data, uint offset, uint numBits)
{
    return (data >> offset) & ((1u << numBits) - 1u);
}
int BitFieldExtractSignExtend(int data, uint offset, uint numBits)
{
    int left = data << (32 - offset - numBits);
    return left >> (32 - numBits);
}
uint BitFieldInsert(uint mask, uint src, uint dst) { return (src & mask) | (dst & ~mask); }
bool IsBitSet(uint data, uint offset) { return ((data >> offset) & 1u) != 0; }
void SetBit(inout uint data, uint offset) { data |= 1u << offset; }
void ClearBit(inout uint data, uint offset) { data &= ~(1u << offset); }
void ToggleBit(inout uint data, uint offset) { data ^= 1u << offset; }
bool HasFlag(uint bitfield, uint flag) { return (bitfield & flag) != 0; }

TEMPLATE_SWAP(Swap)

float2 RotateByAngle(float2 v, float angle)
{
    float s = sin(angle);
    float c = cos(angle);
    return float2(v.x * c - v.y * s, v.x * s + v.y * c);
}

// About an axis through `pivot`, by Rodrigues' formula; the angle in radians.
float3 Rotate(float3 pivot, float3 position, float3 rotationAxis, float angle)
{
    float3 axis = normalize(rotationAxis);
    float3 v = position - pivot;
    float3 along = axis * dot(axis, v);
    float3 across = v - along;
    return pivot + along + across * cos(angle) + cross(axis, v) * sin(angle);
}

// A vector at right angles to the normal, in the plane of the tangent.
float3 Orthonormalize(float3 tangent, float3 normal)
{
    return normalize(tangent - dot(tangent, normal) * normal);
}

// Where t lies between two numbers, 0...1.
TEMPLATE_3_REAL(RangeRemap, low, high, t, return saturate((t - low) / (high - low)))
// The number that lies at t of the way between two.
TEMPLATE_3_REAL(RangeRemapFrom01, low, high, t, return lerp(low, high, t))

// By Cramer's rule. Cross products of the rows (a, b) and (c, d) of the matrix give all cofactors;
// a matrix without an inverse gives infinities.
float4x4 Inverse(float4x4 m)
{
    float3 a = m[0].xyz;
    float3 b = m[1].xyz;
    float3 c = m[2].xyz;
    float3 d = m[3].xyz;
    float3 s = cross(a, b);
    float3 t = cross(c, d);
    float3 u = a * m[1].w - b * m[0].w;
    float3 v = c * m[3].w - d * m[2].w;
    float determinant = dot(s, v) + dot(t, u);
    float4x4 columns = float4x4(float4(cross(b, v) + t * m[1].w, -dot(b, t)),
                                float4(cross(v, a) - t * m[0].w, dot(a, t)),
                                float4(cross(d, u) + s * m[3].w, -dot(d, s)),
                                float4(cross(u, c) - s * m[2].w, dot(c, s)));
    return transpose(columns) * (1.0 / determinant);
}
