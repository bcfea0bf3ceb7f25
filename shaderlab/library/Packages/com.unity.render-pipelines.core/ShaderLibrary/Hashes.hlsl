// Numbers that look random, of whole numbers (Tchou) and of any (sines). A name ends in how many
// numbers go in, how many come out, and of which type they are.
#pragma once
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

void Hash_Tchou_2_3_uint(uint2 q, out uint3 o)
{
    uint y = q.y ^ 1103515245u;
    uint x = (q.x + y) * y;
    x = (x ^ (x >> 5u)) * 0x27d4eb2du;
    y ^= x << 3u;
    o = uint3(x, y, x ^ (y << 5u));
}
void Hash_Tchou_2_2_uint(uint2 v, out uint2 o)
{
    uint3 all;
    Hash_Tchou_2_3_uint(v, all);
    o = all.xy;
}
void Hash_Tchou_2_1_uint(uint2 v, out uint o)
{
    uint3 all;
    Hash_Tchou_2_3_uint(v, all);
    o = all.x;
}
void Hash_Tchou_3_3_uint(uint3 v, out uint3 o)
{
    uint x = v.x ^ 1103515245u;
    uint y = (v.y ^ (x + v.z)) * 134775813u;
    uint z = v.z + (x ^ y);
    y += x ^ z;
    x = (x + y * z) * 0x27d4eb2du;
    z ^= x << 3u;
    o = uint3(x, y + (z << 3u), z);
}
void Hash_Tchou_3_1_uint(uint3 v, out uint o)
{
    uint3 all;
    Hash_Tchou_3_3_uint(v, all);
    o = all.x;
}

// The upper 24 bits as a number of 0...1.
float limn_HashToUnit(uint r) { return (r >> 8) * (1.0 / 16777215.0); }
float2 limn_HashToUnit(uint2 r) { return (r >> 8) * (1.0 / 16777215.0); }
float3 limn_HashToUnit(uint3 r) { return (r >> 8) * (1.0 / 16777215.0); }

void Hash_Tchou_2_1_float(float2 i, out float o)
{
    uint r;
    Hash_Tchou_2_1_uint((uint2)(int2)round(i), r);
    o = limn_HashToUnit(r);
}
void Hash_Tchou_2_2_float(float2 i, out float2 o)
{
    uint2 r;
    Hash_Tchou_2_2_uint((uint2)(int2)round(i), r);
    o = limn_HashToUnit(r);
}
void Hash_Tchou_2_3_float(float2 i, out float3 o)
{
    uint3 r;
    Hash_Tchou_2_3_uint((uint2)(int2)round(i), r);
    o = limn_HashToUnit(r);
}
void Hash_Tchou_3_1_float(float3 i, out float o)
{
    uint r;
    Hash_Tchou_3_1_uint((uint3)(int3)round(i), r);
    o = limn_HashToUnit(r);
}
void Hash_Tchou_3_3_float(float3 i, out float3 o)
{
    uint3 r;
    Hash_Tchou_3_3_uint((uint3)(int3)round(i), r);
    o = limn_HashToUnit(r);
}

void Hash_LegacySine_2_1_float(float2 i, out float o)
{
    o = frac(sin(dot(i, float2(12.9898, 78.233))) * 43758.5453);
}
void Hash_BetterSine_2_1_float(float2 i, out float o)
{
    Hash_LegacySine_2_1_float(i / 1000.0, o);
}
void Hash_LegacySine_2_2_float(float2 i, out float2 o)
{
    o = frac(sin(float2(dot(i, float2(15.27, 99.41)), dot(i, float2(47.63, 89.98)))));
}
// -1...1, again after 289
void Hash_LegacyMod_2_1_float(float2 i, out float o)
{
    i = fmod(i, 289.0);
    float x = fmod((34.0 * i.x + 1.0) * i.x, 289.0) + i.y;
    x = fmod((34.0 * x + 1.0) * x, 289.0);
    o = frac(x / 41.0) * 2.0 - 1.0;
}

#define Hash_Tchou_2_1_half Hash_Tchou_2_1_float
#define Hash_Tchou_2_2_half Hash_Tchou_2_2_float
#define Hash_Tchou_2_3_half Hash_Tchou_2_3_float
#define Hash_Tchou_3_1_half Hash_Tchou_3_1_float
#define Hash_Tchou_3_3_half Hash_Tchou_3_3_float
#define Hash_LegacySine_2_1_half Hash_LegacySine_2_1_float
#define Hash_LegacySine_2_2_half Hash_LegacySine_2_2_float
#define Hash_BetterSine_2_1_half Hash_BetterSine_2_1_float
#define Hash_LegacyMod_2_1_half Hash_LegacyMod_2_1_float
