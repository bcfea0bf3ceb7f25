// Places on a silhouette's edge, found in a mask of several samples a texel, and how a texture keeps
// where the nearest one is: relative to the texel, since a few pixels fit 16 bits much better than
// a picture does. 0 is none, as in a texture that was cleared.
#pragma once

#include "limn/outline/BoxCoverage.hlsl"

// range: pixels; no seed that far away is kept.
float2 EncodeSeed(float2 offset, float range)
{
    return abs(offset.x) < range && abs(offset.y) < range
        ? (offset / range * 32767.0 + 32768.0) / 65535.0
        : 0.0;
}

// From the texel's centre, pixels; far away where there is none.
float2 DecodeSeed(float2 encoded, float range)
{
    return encoded.x > 0.0 ? (encoded * 65535.0 - 32768.0) / 32767.0 * range : 1e9;
}

// A place on the edge within a texel.
struct EdgePlace
{
    bool isEdge;     // if not, only `inside` means anything
    float2 seed;     // from the texel's centre
    float2 outwards; // unit length; 0 where the edge is not straight
    float inside;    // the part of the texel that is inside of the edge
};

// The edge in the middle texel of three by three, coverages row by row from the top left.
// closesSlits: one that no empty texel is next to is none
EdgePlace FindEdge(float mask[9], bool closesSlits)
{
    EdgePlace place;
    float own = mask[4];
    float least = min(min(mask[1], mask[3]), min(mask[5], mask[7]));
    float cornered = min(min(mask[0], mask[2]), min(mask[6], mask[8]));
    bool isSlit = closesSlits && min(least, cornered) > 0.0;
    place.isEdge = own > 0.0 && (own < 1.0 || least == 0.0) && !isSlit;
    place.seed = 0.0;
    place.outwards = 0.0;
    place.inside = isSlit ? 1.0 : own;
    float2 inwards = float2(mask[2] + mask[8] - mask[0] - mask[6] + 2.0 * (mask[5] - mask[3]),
                            mask[6] + mask[8] - mask[0] - mask[2] + 2.0 * (mask[7] - mask[1]));
    float steepness = dot(inwards, inwards);
    if (!place.isEdge || steepness < 1e-4)
    {
        return place;
    }
    float2 outwards = -inwards * rsqrt(steepness);
    // Nine texels know it better than one, if a straight edge through them explains this one.
    float sum = 0.0;
    for (int i = 0; i < 9; i++)
    {
        sum += mask[i];
    }
    float depth = 3.0 * BoxDepth(outwards, sum / 9.0);
    float inside = BoxCoverage(outwards, depth);
    if (abs(inside - own) < 0.2) // less than one of four samples
    {
        place.inside = inside;
        place.outwards = outwards;
    }
    else
    {
        depth = BoxDepth(outwards, own);
    }
    place.seed = outwards * depth;
    return place;
}

// A direction in one number, 0...1; 0 is none.
float EncodeDirection(float2 direction)
{
    return dot(direction, direction) > 0.0
        ? 0.01 + 0.99 * (atan2(direction.y, direction.x) / 6.2831853 + 0.5)
        : 0.0;
}

float2 DecodeDirection(float encoded)
{
    float2 direction;
    sincos(((encoded - 0.01) / 0.99 - 0.5) * 6.2831853, direction.y, direction.x);
    return encoded > 0.0 ? direction : 0.0;
}
