// An outline as the points whose distance to a silhouette's edge, negative inside, is between two
// ends.
#pragma once

#include "limn/outline/BoxCoverage.hlsl"

float4 _WideOutlineBand;  // x, y: the ends; z: where the outer colour is farthest from; w: 1 / how far
float4 _WideOutlineColor;
float4 _WideOutlineOuterColor;
float _WideOutlineFalloff; // 0 = none

// The part of a pixel whose distance is less than `end`.
float PartBelow(float end, float2 direction, float distance, float inside)
{
    // At the edge itself the mask knows it best.
    return end == 0.0 ? inside : BoxCoverage(direction, end - distance);
}

// Whether a pixel of which this part is inside of the edge is on the side where no outline is.
bool IsBesideBand(float inside)
{
    return inside >= 1.0 ? _WideOutlineBand.x == 0.0 || _WideOutlineBand.x > 1.0
                         : inside <= 0.0 && (_WideOutlineBand.y == 0.0 || _WideOutlineBand.y < -1.0);
}

// To the nearest place on the half pixel of edge to either side of a place on it.
float2 AlongEdge(float2 toPlace, float2 outwards)
{
    float2 tangent = float2(-outwards.y, outwards.x);
    return toPlace - tangent * clamp(dot(toPlace, tangent), -0.5, 0.5);
}

// toEdge: from the pixel's centre to the nearest place on the edge; far away = there is none
// inside: the part of the pixel that is inside of the edge
float4 ColorInBand(float2 toEdge, float inside)
{
    float away = length(toEdge);
    float2 direction = away > 1e-3 ? toEdge / away : float2(1.0, 0.0);
    float distance = inside > 0.5 ? -away : away;
    float part = PartBelow(_WideOutlineBand.y, direction, distance, inside) -
        PartBelow(_WideOutlineBand.x, direction, distance, inside);
    float along = saturate(abs(distance - _WideOutlineBand.z) * _WideOutlineBand.w);
    float4 color = lerp(_WideOutlineColor, _WideOutlineOuterColor, along);
    if (_WideOutlineFalloff > 0.0)
    {
        part *= pow(max(1.0 - along, 1e-6), _WideOutlineFalloff);
    }
    color.a *= saturate(part);
    return color;
}
