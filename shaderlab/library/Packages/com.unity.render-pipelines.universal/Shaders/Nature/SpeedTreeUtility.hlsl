#pragma once
#ifndef UNIVERSAL_SPEEDTREE_UTILITY
#define UNIVERSAL_SPEEDTREE_UTILITY

// Where in a pattern of noise a pixel lies that must not swim as the camera turns: by the direction of
// view, at the pixels' size.
uint2 ComputeFadeMaskSeed(float3 V, uint2 positionSS)
{
    if (!IsPerspectiveProjection())
    {
        return positionSS;
    }
    float2 scale = _ScreenParams.xy * float2(UNITY_MATRIX_P[0][0], UNITY_MATRIX_P[1][1]);
    return asuint((int2)(PackNormalOctQuadEncode(V) * scale));
}
#endif
