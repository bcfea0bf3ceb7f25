// Brushes of the Terrain Tools package: where a texel lies in the height map, and whether on a terrain.
#pragma once
#ifndef TERRAIN_TOOLS_INC
#define TERRAIN_TOOLS_INC
#include "TerrainTool.cginc"

float4 _PcUvVectors; // offset and size of what is painted on, in the height map
float4 _PcPixelRect;
sampler2D _PCValidityTex; // above 0 where there is a terrain
float4 _PCValidityTex_TexelSize;
float2 _PrevFilterRange;
float2 _FilterRange;

float2 PcUvToHeightmapUv(float2 pcUV) { return pcUV * _PcUvVectors.zw + _PcUvVectors.xy; }
float2 HeightmapUvToPcUv(float2 heightmapUV)
{
    return (heightmapUV - _PcUvVectors.xy) / _PcUvVectors.zw;
}

float IsPcUvPartOfValidTerrainTileTexel(float2 pcUV)
{
    return tex2D(_PCValidityTex, pcUV).r > 0 ? 1.0 : 0.0;
}
// Only where all of the four neighbours are on one too.
float IsPcUvPartOfValidTerrainTileTexelSobel(float2 pcUV, float2 offset)
{
    float2 u = float2(offset.x, 0);
    float2 v = float2(0, offset.y);
    float sum = tex2D(_PCValidityTex, pcUV - u).r + tex2D(_PCValidityTex, pcUV + u).r +
                tex2D(_PCValidityTex, pcUV - v).r + tex2D(_PCValidityTex, pcUV + v).r;
    return sum + tex2D(_PCValidityTex, pcUV).r > 4 ? 1.0 : 0.0;
}

// From the range of o to p to that of a to b.
float RemapFilterValue(float4 n, float o, float p, float a, float b)
{
    return lerp(a, b, (n.x - o) / (p - o));
}
float pow_keep_sign(float4 f, float p) { return sign(f.x) * pow(abs(f.x), p); }
#endif
