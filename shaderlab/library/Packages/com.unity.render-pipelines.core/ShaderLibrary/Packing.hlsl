// Vectors and numbers in the few bits of a texture.
#pragma once
#ifndef UNITY_PACKING_INCLUDED
#define UNITY_PACKING_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

// Normals in textures: x and y in 0...1, z follows. Works for x in red and for x in alpha where
// red is 1.
float3 UnpackNormalmapRGorAG(float4 packedNormal, float scale = 1.0)
{
    float2 xy = float2(packedNormal.r * packedNormal.a, packedNormal.g) * 2.0 - 1.0;
    float z = sqrt(max(1e-16, 1.0 - saturate(dot(xy, xy))));
    return float3(xy * scale, z);
}
float3 UnpackNormalScale(float4 packedNormal, float scale)
{
    return UnpackNormalmapRGorAG(packedNormal, scale);
}
float3 UnpackNormal(float4 packedNormal) { return UnpackNormalmapRGorAG(packedNormal); }
float3 UnpackNormalAG(float4 packedNormal, float scale = 1.0)
{
    return UnpackNormalmapRGorAG(float4(1.0, packedNormal.gba), scale);
}
float3 UnpackNormalRGBNoScale(float4 packedNormal) { return packedNormal.rgb * 2.0 - 1.0; }
float3 UnpackNormalRGB(float4 packedNormal, float scale = 1.0)
{
    float3 normal = UnpackNormalRGBNoScale(packedNormal);
    return float3(normal.xy * scale, normal.z);
}
float3 PackNormalMaxComponent(float3 n)
{
    return n / max(abs(n.x), max(abs(n.y), abs(n.z))) * 0.5 + 0.5;
}
float3 UnpackNormalMaxComponent(float3 n) { return normalize(n * 2.0 - 1.0); }

// Unit vectors on an octahedron, unfolded to -1...1.
float2 PackNormalOctQuadEncode(float3 n)
{
    n /= max(dot(abs(n), float3(1, 1, 1)), 1e-6);
    float fold = saturate(-n.z);
    return n.xy + float2(n.x >= 0.0 ? fold : -fold, n.y >= 0.0 ? fold : -fold);
}
float3 UnpackNormalOctQuadEncode(float2 f)
{
    float3 n = float3(f, 1.0 - abs(f.x) - abs(f.y));
    float fold = max(-n.z, 0.0);
    n.xy += float2(n.x >= 0.0 ? -fold : fold, n.y >= 0.0 ? -fold : fold);
    return normalize(n);
}
// The octahedron cut into its two halves, lower and upper, side by side in a rectangle: x is 0...1
// above and -1...0 below, y is -1...1.
float2 PackNormalOctRectEncode(float3 n)
{
    float2 p = n.xy / dot(abs(n), float3(1, 1, 1));
    float side = saturate((p.y - p.x) * 0.5 + 0.5);
    return float2(n.z < 0.0 ? -side : side, p.x + p.y);
}
float3 UnpackNormalOctRectEncode(float2 f)
{
    float x = 0.5 * f.y - abs(f.x) + 0.5;
    float2 p = float2(x, f.y - x);
    float height = max(1.0 - abs(p.x) - abs(p.y), FLT_EPS);
    return normalize(float3(p, f.x < 0.0 ? -height : height));
}
// The upper half of the octahedron (z >= 0), turned by 45 degrees so that it fills the square.
float2 PackNormalHemiOctEncode(float3 n)
{
    float2 p = n.xy / dot(abs(n), float3(1, 1, 1));
    return float2(p.x + p.y, p.x - p.y);
}
float3 UnpackNormalHemiOctEncode(float2 f)
{
    float2 p = float2(f.x + f.y, f.x - f.y) * 0.5;
    return normalize(float3(p, 1.0 - dot(abs(p), float2(1, 1))));
}

// Whole numbers as fractions of the largest one, and back.
float PackInt(uint i, uint numBits) { return (float)i / (float)((1u << numBits) - 1u); }
uint UnpackInt(float f, uint numBits) { return (uint)(f * (float)((1u << numBits) - 1u) + 0.5); }
float PackByte(uint i) { return PackInt(i, 8); }
uint UnpackByte(float f) { return UnpackInt(f, 8); }
float PackShort(uint i) { return PackInt(i, 16); }
uint UnpackShort(float f) { return UnpackInt(f, 16); }
float PackShortLo(uint i) { return PackByte(i & 0xFFu); }
float PackShortHi(uint i) { return PackByte(i >> 8); }

// A number in 0...1 is a bit field of a word.
uint PackFloatToUInt(float src, uint offset, uint numBits)
{
    return UnpackInt(src, numBits) << offset;
}
float UnpackUIntToFloat(uint src, uint offset, uint numBits)
{
    return PackInt((src >> offset) & ((1u << numBits) - 1u), numBits);
}
uint PackToR10G10B10A2(float4 rgba)
{
    uint3 rgb = uint3(UnpackInt(rgba.r, 10), UnpackInt(rgba.g, 10), UnpackInt(rgba.b, 10));
    return rgb.r | (rgb.g << 10) | (rgb.b << 20) | (UnpackInt(rgba.a, 2) << 30);
}
float4 UnpackFromR10G10B10A2(uint rgba)
{
    return float4(UnpackUIntToFloat(rgba, 0, 10), UnpackUIntToFloat(rgba, 10, 10),
                  UnpackUIntToFloat(rgba, 20, 10), UnpackUIntToFloat(rgba, 30, 2));
}

// A fraction f and a whole number i below maxi share one number in 0...1, which has `precision` steps:
// each i has an equal part of them.
float PackFloatInt(float f, uint i, float maxi, float precision)
{
    float share = precision / maxi;
    return (f * (share - 1.0) + i * share) / (precision - 1.0);
}
void UnpackFloatInt(float val, float maxi, float precision, out float f, out uint i)
{
    float share = precision / maxi;
    float code = val * (precision - 1.0);
    i = (uint)(code / share + rcp(precision - 1.0));
    f = saturate((code - i * share) / (share - 1.0));
}
float PackFloatInt8bit(float f, uint i, float maxi) { return PackFloatInt(f, i, maxi, 256.0); }
void UnpackFloatInt8bit(float val, float maxi, out float f, out uint i)
{
    UnpackFloatInt(val, maxi, 256.0, f, i);
}
float PackFloatInt10bit(float f, uint i, float maxi) { return PackFloatInt(f, i, maxi, 1024.0); }
void UnpackFloatInt10bit(float val, float maxi, out float f, out uint i)
{
    UnpackFloatInt(val, maxi, 1024.0, f, i);
}
float PackFloatInt16bit(float f, uint i, float maxi) { return PackFloatInt(f, i, maxi, 65536.0); }
void UnpackFloatInt16bit(float val, float maxi, out float f, out uint i)
{
    UnpackFloatInt(val, maxi, 65536.0, f, i);
}

// A number in 0...1 in two bytes, the low one first.
float2 PackFloatToR8G8(float f)
{
    uint bits = UnpackShort(f);
    return float2(PackShortLo(bits), PackShortHi(bits));
}
float UnpackFloatFromR8G8(float2 f) { return PackShort(UnpackByte(f.x) | (UnpackByte(f.y) << 8)); }

// Two numbers in 0...1 in three bytes: 12 bits each.
float3 PackFloat2To888(float2 f)
{
    uint2 bits = (uint2)(f * 4095.5);
    uint3 bytes = uint3(bits & 0xFFu, (bits.x >> 8) | ((bits.y >> 8) << 4));
    return bytes / 255.0;
}
float2 Unpack888ToFloat2(float3 x)
{
    uint3 bytes = (uint3)(x * 255.0 + 0.5);
    uint2 bits = bytes.xy | uint2((bytes.z & 0xFu) << 8, (bytes.z >> 4) << 8);
    return bits / 4095.0;
}
// Two numbers in 0...1 in one byte: 4 bits each.
float PackFloat2To8(float2 f)
{
    float2 bits = round(saturate(f) * 15.0);
    return (bits.x * 16.0 + bits.y) / 255.0;
}
float2 Unpack8ToFloat2(float f)
{
    uint bits = (uint)(f * 255.0 + 0.5);
    return float2(bits >> 4, bits & 15u) / 15.0;
}
// 11, 11 and 10 bits of positive numbers in one, by cutting bits off halves.
uint PackToR11G11B10f(float3 rgb)
{
    uint r = (f32tof16(rgb.x) << 17) & 0xFFE00000u;
    uint g = (f32tof16(rgb.y) << 6) & 0x001FFC00u;
    uint b = (f32tof16(rgb.z) >> 5) & 0x000003FFu;
    return r | g | b;
}
float3 UnpackFromR11G11B10f(uint rgb)
{
    return float3(f16tof32((rgb >> 17) & 0x7FF0u), f16tof32((rgb >> 6) & 0x7FF0u),
                  f16tof32((rgb << 5) & 0x7FE0u));
}
#endif
