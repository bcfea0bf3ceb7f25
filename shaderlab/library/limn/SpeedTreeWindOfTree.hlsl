// What the vertex functions of all SpeedTrees do with the wind, by its quality. Without ENABLE_WIND
// the functions are there and move nothing.
#pragma once

#ifdef ENABLE_WIND
#define WIND_QUALITY_NONE 0
#define WIND_QUALITY_FASTEST 1
#define WIND_QUALITY_FAST 2
#define WIND_QUALITY_BETTER 3
#define WIND_QUALITY_BEST 4
#define WIND_QUALITY_PALM 5
#include "SpeedTreeWind.cginc"
#endif

struct limn_TreeWind
{
    float quality; // 0: calm
    float3 way;    // in object space, of length 1
    float3 branchAnchor;
    float3 tree; // where it stands
};

// A leaf's offset from its anchor, turned as the camera is.
float3 limn_FaceCamera(float3 offset)
{
    return normalize(mul(offset, (float3x3)UNITY_MATRIX_IT_MV)) * length(offset);
}

limn_TreeWind limn_CalmTree()
{
    limn_TreeWind wind;
    wind.quality = 0;
    wind.way = 0;
    wind.branchAnchor = 0;
    wind.tree = UNITY_MATRIX_M._14_24_34;
    return wind;
}

#ifdef ENABLE_WIND
// Calm where no script has set a wind.
limn_TreeWind limn_WindOfTree(float quality)
{
    limn_TreeWind wind = limn_CalmTree();
    float3 way = mul(_ST_WindVector.xyz, (float3x3)UNITY_MATRIX_M);
    if (quality > WIND_QUALITY_NONE && length(way) >= 1e-5)
    {
        wind.quality = quality;
        wind.way = normalize(way);
        wind.branchAnchor = limn_ST_OfLength(
            mul(_ST_WindBranchAnchor.xyz, (float3x3)UNITY_MATRIX_M), _ST_WindBranchAnchor.w);
    }
    return wind;
}
#endif

// leaf: how much, which way it grows, which way it ripples.
void limn_BlowLeaf(limn_TreeWind wind, bool isSecond, float3 anchor, float3 leaf,
                   inout float3 offset, inout float3 normal)
{
#ifdef ENABLE_WIND
    if (wind.quality > WIND_QUALITY_FASTEST && wind.quality < WIND_QUALITY_PALM)
    {
        offset = LeafWind(wind.quality == WIND_QUALITY_BEST, isSecond, offset, normal, leaf.x,
                          float3(0, 0, 0), leaf.y, leaf.z, anchor.x + anchor.y, wind.way);
    }
#endif
}

void limn_BlowFrond(limn_TreeWind wind, float2 uv, float3 frond, inout float3 position,
                    inout float3 normal)
{
#if defined(ENABLE_WIND) && !defined(WIND_EFFECT_FROND_RIPPLE_ADJUST_LIGHTING)
    if (wind.quality == WIND_QUALITY_PALM)
    {
        position = RippleFrond(position, normal, uv.x, uv.y, frond.x, frond.y, frond.z);
    }
#endif
}

// branch: weight and offset.
float3 limn_BlowBranch(limn_TreeWind wind, float2 branch, float3 position)
{
#ifdef ENABLE_WIND
    if (wind.quality >= WIND_QUALITY_BETTER)
    {
        return BranchWind(wind.quality == WIND_QUALITY_PALM, position, wind.tree,
                          float4(branch, 0, 0), wind.way, wind.branchAnchor);
    }
#endif
    return position;
}

float3 limn_BlowTree(limn_TreeWind wind, float3 position)
{
#ifdef ENABLE_WIND
    if (wind.quality > WIND_QUALITY_NONE)
    {
        return GlobalWind(position, wind.tree, true, wind.way, _ST_WindGlobal.x);
    }
#endif
    return position;
}
