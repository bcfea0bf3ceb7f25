// How far a point has moved over the screen since the last frame.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

// In texture coordinates of the screen.
float2 CalcNdcMotionVectorFromCsPositions(float4 posCS, float4 prevPosCS)
{
    float2 moved = posCS.xy / posCS.w - prevPosCS.xy / prevPosCS.w;
    return float2(moved.x, -moved.y) * 0.5;
}
// In clip space after the division by w.
float3 CalcAswNdcMotionVectorFromCsPositions(float4 posCS, float4 prevPosCS)
{
    return posCS.xyz / posCS.w - prevPosCS.xyz / prevPosCS.w;
}
