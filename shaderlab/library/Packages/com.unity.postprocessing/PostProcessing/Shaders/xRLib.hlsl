// There is one eye: nothing depends on which.
#pragma once

#define _RenderViewportScaleFactor 1.0

float2 UnityStereoScreenSpaceUVAdjust(float2 uv, float4 scaleAndOffset)
{
    return uv * scaleAndOffset.xy + scaleAndOffset.zw;
}
float2 TransformStereoScreenSpaceTex(float2 uv, float w) { return uv; }
float2 UnityStereoClamp(float2 uv) { return uv; }
