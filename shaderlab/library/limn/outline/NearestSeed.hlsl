// The nearest seed of EdgeSeeds.hlsl, by jump flooding (Rong and Tan 2006) or column by column.
// Textures are of one size, that of what is drawn into.
#pragma once

#include "limn/outline/EdgeSeeds.hlsl"

float4 _WideOutlineSize;  // of the textures: 1/width, 1/height, width, height
float _WideOutlineRange;  // seeds this far away, pixels, are none
float _WideOutlineStep;   // pixels: how far apart flooding looks, how far columns and rows do
float _WideOutlineAside;  // pixels: from how far beside it a column is looked at

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

// Of the texel's column: the nearest to a place on the right (xy) and to one on the left (zw),
// encoded. Seeds are not in the middle of their texels, so which is nearest depends on where one
// stands.
float4 ColumnSeeds(float2 center)
{
    float2 aside = float2(_WideOutlineAside, 0.0);
    float2 fromRight = k_NoSeed;
    float2 fromLeft = k_NoSeed;
    float first = max(-_WideOutlineStep, 0.5 - center.y);
    float last = min(_WideOutlineStep, _WideOutlineSize.w - 0.5 - center.y);
    for (float y = first; y <= last; y += 1.0)
    {
        float2 seed = DecodeSeed(SeedTexel(center + float2(0.0, y)).xy, _WideOutlineRange);
        seed.y += y;
        fromRight = Nearer(fromRight, seed - aside);
        fromLeft = Nearer(fromLeft, seed + aside);
    }
    return float4(EncodeSeed(fromRight + aside, _WideOutlineRange),
                  EncodeSeed(fromLeft - aside, _WideOutlineRange));
}

// Of the columns on both sides, not encoded.
float2 RowSeed(float2 center)
{
    float2 nearest = k_NoSeed;
    float first = max(-_WideOutlineStep, 0.5 - center.x);
    float last = min(_WideOutlineStep, _WideOutlineSize.z - 0.5 - center.x);
    for (float x = first; x <= last; x += 1.0)
    {
        float4 column = SeedTexel(center + float2(x, 0.0));
        float2 seed = DecodeSeed(x < 0.0 ? column.xy : column.zw, _WideOutlineRange);
        nearest = Nearer(nearest, float2(x, 0.0) + seed);
    }
    return nearest;
}
