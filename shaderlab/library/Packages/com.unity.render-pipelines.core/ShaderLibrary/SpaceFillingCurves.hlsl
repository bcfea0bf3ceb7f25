// Morton's curve: the bits of coordinates, one of each in turn.
#pragma once
#ifndef UNITY_SPACE_FILLING_CURVES_INCLUDED
#define UNITY_SPACE_FILLING_CURVES_INCLUDED

// The lower 16 bits with one bit free between two of them, and back.
uint Part1By1(uint x)
{
    x &= 0xffffu;
    x = (x | x << 8) & 0x00ff00ffu;
    x = (x | x << 4) & 0x0f0f0f0fu;
    x = (x | x << 2) & 0x33333333u;
    return (x | x << 1) & 0x55555555u;
}
uint Compact1By1(uint x)
{
    x &= 0x55555555u;
    x = (x | x >> 1) & 0x33333333u;
    x = (x | x >> 2) & 0x0f0f0f0fu;
    x = (x | x >> 4) & 0x00ff00ffu;
    return (x | x >> 8) & 0xffffu;
}
// The lower 10 bits with two free between two of them, and back.
uint Part1By2(uint x)
{
    x &= 0x3ffu;
    x = (x | x << 16) & 0xff0000ffu;
    x = (x | x << 8) & 0x0300f00fu;
    x = (x | x << 4) & 0x030c30c3u;
    return (x | x << 2) & 0x09249249u;
}
uint Compact1By2(uint x)
{
    x &= 0x09249249u;
    x = (x | x >> 2) & 0x030c30c3u;
    x = (x | x >> 4) & 0x0300f00fu;
    x = (x | x >> 8) & 0xff0000ffu;
    return (x | x >> 16) & 0x3ffu;
}

uint EncodeMorton2D(uint2 coord) { return Part1By1(coord.x) | Part1By1(coord.y) << 1; }
uint EncodeMorton3D(uint3 coord)
{
    return Part1By2(coord.x) | Part1By2(coord.y) << 1 | Part1By2(coord.z) << 2;
}
uint2 DecodeMorton2D(uint code) { return uint2(Compact1By1(code), Compact1By1(code >> 1)); }
uint3 DecodeMorton3D(uint code)
{
    return uint3(Compact1By2(code), Compact1By2(code >> 1), Compact1By2(code >> 2));
}
#endif
