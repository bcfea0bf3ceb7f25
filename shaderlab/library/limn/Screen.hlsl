// Where the screen and the depth buffer are met: one home for both pipelines.
#pragma once

#include "limn/Globals.hlsl"

// Texture coordinate of the screen, times w; v runs down from the top, as rows of textures do.
float4 limn_ScreenPos(float4 positionCS)
{
    float2 ndc = float2(positionCS.x, -positionCS.y);
    return float4(ndc * 0.5 + positionCS.w * 0.5, positionCS.zw);
}

// 0 at the camera, 1 at the far plane; perspective. zBufferParams is _ZBufferParams.
float limn_Linear01Depth(float depth, float4 zBufferParams)
{
    return 1.0 / (zBufferParams.x * depth + zBufferParams.y);
}

// Distance along the view axis; perspective.
float limn_LinearEyeDepth(float depth, float4 zBufferParams)
{
    return 1.0 / (zBufferParams.z * depth + zBufferParams.w);
}

// Distance along the view axis from what clip space has in z; any distance behind the near plane
// is 0.
float limn_DistanceFromClipZ(float clipZ)
{
    return max((1.0 - clipZ / _ProjectionParams.y) * _ProjectionParams.z, 0.0);
}
