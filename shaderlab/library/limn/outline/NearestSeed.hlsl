// The nearest seed of EdgeSeeds.hlsl, by jump flooding (Rong and Tan 2006) or column by column.
// Textures are of one size, that of what is drawn into.
#pragma once

#include "limn/outline/EdgeSeeds.hlsl"

float4 _WideOutlineSize;  // of the textures: 1/width, 1/height, width, height
float _WideOutlineRange;  // seeds this far away, pixels, are none
float _WideOutlineStep;   // pixels: how far apart flooding looks, how far columns and rows do
float _WideOutlineAside;  // pixels: from how far beside it a column is looked at
float4 _WideOutlineObjects; // centres of the first (xy) and the last texel (zw) that can have seeds

static const float2 k_NoSeed = 1e9;

// center: the texel's; a nearest sampler is cheaper than a load, which tests bounds.
float4 SeedTexel(float2 center)
{
    return SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_PointClamp, center * _WideOutlineSize.xy, 0);
}

float2 Nearer(float2 a, float2 b)
{
    return dot(b, b) < dot(a, a) ? b : a;
}

// Of those that nine texels know, encoded.
float2 FloodSeeds(float2 center)
{
    float2 nearest = k_NoSeed;
    for (int i = 0; i < 9; i++)
    {
        float2 there = center + _WideOutlineStep * float2(i % 3 - 1, i / 3 - 1);
        there = clamp(there, 0.5, _WideOutlineSize.zw - 0.5);
        float2 seed = DecodeSeed(SeedTexel(there).xy, _WideOutlineRange);
        nearest = Nearer(nearest, there - center + seed);
    }
    return EncodeSeed(nearest, _WideOutlineRange);
}

// Whether a texel so far along a line can have a seed as near as `distance`, both squared or not;
// seeds are less than a texel beside their texel's centre.
bool MayBeNear(float along, float squaredDistance)
{
    float least = abs(along) - 1.0;
    return least * least <= squaredDistance;
}

// Of the texel's column: the nearest to a place on the right (xy) and to one on the left (zw),
// encoded. Seeds are not in the middle of their texels, so which is nearest depends on where one
// stands. From the texel outwards, until nothing nearer can follow; of equals the first of the
// column.
float4 ColumnSeeds(float2 center)
{
    if (center.x < _WideOutlineObjects.x || center.x > _WideOutlineObjects.z)
    {
        return 0.0;
    }
    float2 aside = float2(_WideOutlineAside, 0.0);
    float beside = max(_WideOutlineAside - 1.0, 0.0);
    beside *= beside;
    float2 fromRight = k_NoSeed;
    float2 fromLeft = k_NoSeed;
    float farthest = dot(fromRight, fromRight);
    float first = max(-_WideOutlineStep, _WideOutlineObjects.y - center.y);
    float last = min(_WideOutlineStep, _WideOutlineObjects.w - center.y);
    for (float up = min(0.0, last); up >= first && MayBeNear(up, farthest - beside); up -= 1.0)
    {
        float2 seed = DecodeSeed(SeedTexel(center + float2(0.0, up)).xy, _WideOutlineRange);
        seed.y += up;
        fromRight = Nearer(seed - aside, fromRight);
        fromLeft = Nearer(seed + aside, fromLeft);
        farthest = max(dot(fromRight, fromRight), dot(fromLeft, fromLeft));
    }
    for (float down = max(1.0, first); down <= last && MayBeNear(down, farthest - beside); down += 1.0)
    {
        float2 seed = DecodeSeed(SeedTexel(center + float2(0.0, down)).xy, _WideOutlineRange);
        seed.y += down;
        fromRight = Nearer(fromRight, seed - aside);
        fromLeft = Nearer(fromLeft, seed + aside);
        farthest = max(dot(fromRight, fromRight), dot(fromLeft, fromLeft));
    }
    return float4(EncodeSeed(fromRight + aside, _WideOutlineRange),
                  EncodeSeed(fromLeft - aside, _WideOutlineRange));
}

// Of the columns on both sides, not encoded; in the same order.
float2 RowSeed(float2 center)
{
    float2 nearest = k_NoSeed;
    float first = max(-_WideOutlineStep, _WideOutlineObjects.x - center.x);
    float last = min(_WideOutlineStep, _WideOutlineObjects.z - center.x);
    for (float left = min(0.0, last); left >= first && MayBeNear(left, dot(nearest, nearest)); left -= 1.0)
    {
        float4 column = SeedTexel(center + float2(left, 0.0));
        float2 seed = DecodeSeed(left < 0.0 ? column.xy : column.zw, _WideOutlineRange);
        nearest = Nearer(float2(left, 0.0) + seed, nearest);
    }
    for (float right = max(1.0, first); right <= last && MayBeNear(right, dot(nearest, nearest)); right += 1.0)
    {
        float2 seed = DecodeSeed(SeedTexel(center + float2(right, 0.0)).zw, _WideOutlineRange);
        nearest = Nearer(nearest, float2(right, 0.0) + seed);
    }
    return nearest;
}
